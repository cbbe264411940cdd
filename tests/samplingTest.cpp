#include "swSampling.h"

#include <set>
#include <thread>
#include <vector>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

std::vector<float> numbersOf(std::uint64_t seed, int x, int y, int count) {
    seedPixel(seed, x, y);
    std::vector<float> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(uniform());
    return numbers;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (static_cast<double>(a[i]) - 0.5) * (static_cast<double>(b[i]) - 0.5);
    return sum / static_cast<double>(a.size()) * 12;  // a uniform number's variance is 1/12
}

}  // namespace

TEST_CASE("numbers lie in 0 to 1 and use all 24 bits") {
    const auto seed = GENERATE(range(0u, 5u));
    CAPTURE(seed);
    int outside = 0, offGrid = 0;
    std::uint32_t ones = 0, zeros = 0;
    float least = 1, most = 0;
    for (const float r : numbersOf(seed, 3, 4, 1 << 20)) {
        const float scaled = r * 0x1p24f;
        if (!(r >= 0 && r < 1)) ++outside;
        if (scaled != std::floor(scaled)) ++offGrid;
        ones |= static_cast<std::uint32_t>(scaled);
        zeros |= ~static_cast<std::uint32_t>(scaled);
        least = std::min(least, r);
        most = std::max(most, r);
    }
    CHECK(outside == 0);
    CHECK(offGrid == 0);
    CHECK((ones & 0xffffff) == 0xffffff);
    CHECK((zeros & 0xffffff) == 0xffffff);
    // Each of these fails once in e^16 seeds.
    CHECK(least < 0x1p-16f);
    CHECK(most > 1 - 0x1p-16f);
}

TEST_CASE("numbers have the mean and the variance of a uniform distribution") {
    const auto seed = GENERATE(range(0u, 20u));
    CAPTURE(seed);
    constexpr int n = 100000;
    double sum = 0, squares = 0;
    for (const float r : numbersOf(seed, 100, 7, n)) {
        const double centered = static_cast<double>(r) - 0.5;
        sum += centered;
        squares += centered * centered;
    }
    // Five standard deviations: sqrt(1/12 / n) of the mean, sqrt(1/180 / n) of the variance.
    CHECK(std::fabs(sum / n) < 5 * std::sqrt(1.0 / 12 / n));
    CHECK(std::fabs(squares / n - 1.0 / 12) < 5 * std::sqrt(1.0 / 180 / n));
}

TEST_CASE("the first numbers of neighbouring pixels are uniform in every cell of a grid") {
    // What samplePixel needs: the pairs spread evenly. Chi-square with 255 degrees of freedom.
    const auto seed = GENERATE(0u, 1u, 2u);
    CAPTURE(seed);
    constexpr int side = 256;
    std::vector<int> cells(256);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const auto pair = numbersOf(seed, x, y, 2);
            ++cells[static_cast<std::size_t>(pair[0] * 16) * 16 +
                    static_cast<std::size_t>(pair[1] * 16)];
        }
    }
    const double expected = side * side / 256.0;
    double chiSquare = 0;
    for (const int n : cells) chiSquare += (n - expected) * (n - expected) / expected;
    CHECK(std::fabs(chiSquare - 255) < 5 * std::sqrt(2 * 255.0));
}

TEST_CASE("a pixel's numbers depend on seed and position alone") {
    Random random(GENERATE(range(0u, 50u)));
    const auto seed = static_cast<std::uint64_t>(random.whole(0, 1 << 30));
    const int x = random.whole(0, 16383), y = random.whole(0, 16383);
    CAPTURE(seed, x, y);
    const auto first = numbersOf(seed, x, y, 20);
    numbersOf(seed + 1, y, x, random.whole(0, 9));
    CHECK(numbersOf(seed, x, y, 20) == first);
    // Another thread gets the same numbers, in the middle of ours.
    seedPixel(seed, x, y);
    std::vector<float> elsewhere, here;
    for (int i = 0; i < 10; ++i) here.push_back(uniform());
    std::thread([&] { elsewhere = numbersOf(seed, x, y, 20); }).join();
    for (int i = 0; i < 10; ++i) here.push_back(uniform());
    CHECK(elsewhere == first);
    CHECK(here == first);
}

TEST_CASE("different pixels and different seeds are uncorrelated") {
    const auto [seed, x, y] =
        GENERATE(table<std::uint64_t, int, int>({{1, 1, 0},
                                                 {1, 0, 1},
                                                 {1, -1, 0},
                                                 {1, 512, 511},
                                                 {2, 0, 0},
                                                 {2, -1, 0},
                                                 {2, 0, -1},
                                                 {0, 0, 0},
                                                 {1ULL << 32, 0, 0},
                                                 {0x9e3779b97f4a7c16, 0, 0}}));
    CAPTURE(seed, x, y);
    constexpr int n = 50000;
    const auto here = numbersOf(1, 512, 512, n);
    const auto there = numbersOf(seed, 512 + x, 512 + y, n);
    CHECK(std::fabs(correlation(here, there)) < 5 / std::sqrt(n));
    // Nor are they the same numbers, a step later.
    for (std::size_t lag = 1; lag < 4; ++lag) {
        const std::vector<float> later(there.begin() + static_cast<std::ptrdiff_t>(lag),
                                       there.end());
        CHECK(std::fabs(correlation({here.begin(), here.end() - static_cast<std::ptrdiff_t>(lag)},
                                    later)) < 5 / std::sqrt(n));
    }
}

TEST_CASE("no two pixels of a picture start alike") {
    const auto [left, top] = GENERATE(table<int, int>({{0, 0}, {15360, 0}, {0, 16320}}));
    CAPTURE(left, top);
    std::set<std::pair<float, float>> starts;
    for (int y = top; y < top + 64; ++y) {
        for (int x = left; x < left + 1024; ++x) {
            const auto pair = numbersOf(1, x, y, 2);
            starts.insert({pair[0], pair[1]});
        }
    }
    CHECK(starts.size() == 64 * 1024);
}
