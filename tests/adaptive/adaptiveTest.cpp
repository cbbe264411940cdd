#include "swAdaptive.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "support.h"
#include "swSampling.h"

using namespace sw;
using namespace test;

namespace {

using Radiance = std::function<Color(float, float)>;

constexpr int size = 64;
const Window whole{0, 0, size, size};

AdaptiveOptions tolerance(float value, int threads = 1, int tileSize = 16) {
    AdaptiveOptions options;
    options.tolerance = value;
    options.render.threads = threads;
    options.render.tileSize = tileSize;
    return options;
}

AdaptiveResult rendered(const Radiance& radiance, const AdaptiveOptions& options,
                        const Window& window = whole) {
    return renderAdaptive(window, size, size, radiance, options);
}

Color grey(float value) {
    return {value, value, value};
}

// Hairs that are followed over many pixels, a disc, a slope, and noise that never converges.
Color busy(float x, float y) {
    if (std::fabs(y - 0.31f * x - 20) < 0.1f || std::fabs(x - 0.77f * y - 3) < 0.05f)
        return {1, 0.5f, 0};
    if ((x - 40) * (x - 40) + (y - 45) * (y - 45) < 100) return {0, x / size, 1};
    if (x < 8 && y < 8) return {uniform(), uniform(), uniform()};
    return grey(y / size / 4);
}

// Of all pixels, without what the audit took.
int sumOf(const std::vector<int>& counts) {
    return std::accumulate(counts.begin(), counts.end(), 0);
}

int largest(const std::vector<int>& counts) {
    return *std::max_element(counts.begin(), counts.end());
}

// Pixels of the part that differ in any bit, in colour or number of samples, from the whole.
int differences(const AdaptiveResult& part, const Window& window, const AdaptiveResult& all) {
    int count = 0;
    for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x) {
            const auto there = static_cast<std::size_t>(y * size + x);
            const auto here =
                static_cast<std::size_t>((y - window.y0) * window.width() + x - window.x0);
            count += !isSame(part.image.at(x - window.x0, y - window.y0), all.image.at(x, y)) ||
                     part.sampleCounts[here] != all.sampleCounts[there];
        }
    }
    return count;
}

}  // namespace

TEST_CASE("one colour takes one sample per pixel and has no error", "[adaptive]") {
    const AdaptiveResult result =
        rendered([](float, float) { return Color(0.2f, 0.4f, 0.6f); }, tolerance(1e-6f));
    CHECK(sumOf(result.sampleCounts) == size * size);
    CHECK(result.estimatedRmse == 0);
    CHECK(distance(result.image.at(17, 5), Vec3(0.2f, 0.4f, 0.6f)) == 0);
}

TEST_CASE(
    "a smooth slope takes one sample per pixel and becomes its value at "
    "the centres",
    "[adaptive]") {
    const AdaptiveResult result = rendered(
        [](float x, float y) { return Color(0.01f * x, 0.008f * y, 0.5f); }, tolerance(0.003f));
    for (int y = 1; y < size - 1; ++y) {
        for (int x = 1; x < size - 1; ++x) {
            CHECK(result.sampleCounts[static_cast<std::size_t>(y * size + x)] == 1);
            CHECK(distance(result.image.at(x, y),
                           Vec3(0.01f * (static_cast<float>(x) + 0.5f),
                                0.008f * (static_cast<float>(y) + 0.5f), 0.5f)) < 1e-5);
        }
    }
}

TEST_CASE("an edge is refined, and flat pixels beside it are not", "[adaptive]") {
    const AdaptiveResult result =
        rendered([](float x, float y) { return grey(x + 0.4f * y > 40.3f ? 0.9f : 0.1f); },
                 tolerance(0.02f));
    CHECK(sumOf(result.sampleCounts) < 3 * size * size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            // How far the edge is to the right of the pixel's centre.
            const float ahead =
                40.3f - 0.4f * (static_cast<float>(y) + 0.5f) - (static_cast<float>(x) + 0.5f);
            const float value = result.image.at(x, y)[0];
            if (std::fabs(ahead) > 4)
                CHECK(result.sampleCounts[static_cast<std::size_t>(y * size + x)] == 1);
            if (std::fabs(ahead) < 0.3f)  // the edge crosses top and bottom
                CHECK(std::fabs(value - (0.9f - 0.8f * (0.5f + ahead))) < 0.08f);
        }
    }
}

TEST_CASE(
    "no error stays above the tolerance, except where a pixel has all "
    "its samples",
    "[adaptive]") {
    const float limit = GENERATE(0.1f, 0.02f, 0.005f);
    const AdaptiveResult result = rendered(busy, tolerance(limit));
    int above = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            above += result.errors.at(x, y)[0] > limit &&
                     result.sampleCounts[static_cast<std::size_t>(y * size + x)] < 1024;
    CHECK(above <= size * size / 200);  // found by the last pass
}

TEST_CASE("threads and tiles do not change a bit", "[adaptive]") {
    const AdaptiveResult one = rendered(busy, tolerance(0.01f));
    const auto threads = GENERATE(2, 5);
    const auto tileSize = GENERATE(1, 7, 100);
    const AdaptiveResult other = rendered(busy, tolerance(0.01f, threads, tileSize));
    CHECK(differences(other, whole, one) == 0);
    CHECK(other.samples == one.samples);
    CHECK(other.estimatedRmse == one.estimatedRmse);
}

TEST_CASE("a crop shows the picture's pixels to the last bit", "[adaptive]") {
    const auto seed = GENERATE(range(0u, 12u));
    CAPTURE(seed);
    Random random(seed);
    const int x = random.whole(0, size - 1), y = random.whole(0, size - 1);
    const Window window{x, y, random.whole(x + 1, size), random.whole(y + 1, size)};
    const float limit = random.magnitude(0.003, 0.1);
    CHECK(differences(rendered(busy, tolerance(limit), window), window,
                      rendered(busy, tolerance(limit))) == 0);
}

TEST_CASE("another seed takes other samples", "[adaptive]") {
    AdaptiveOptions other = tolerance(0.01f);
    other.render.seed = 2;
    CHECK(differences(rendered(busy, other), whole, rendered(busy, tolerance(0.01f))) > 100);
}

TEST_CASE("no pixel takes more samples than it may", "[adaptive]") {
    const auto most = GENERATE(1, 3, 4, 100, 4096, 1000000);
    AdaptiveOptions options = tolerance(1e-5f);
    options.maxSamples = most;
    const AdaptiveResult result = rendered(busy, options, {0, 0, 4, 4});
    const int expected = most < 4 ? 1 : most == 100 ? 64 : std::min(most, 4096);
    CHECK(largest(result.sampleCounts) == expected);
}

TEST_CASE("rendering ends when the time is up or the caller says so", "[adaptive]") {
    AdaptiveOptions options;
    std::vector<AdaptiveProgress> seen;
    SECTION("time") {
        options.timeLimit = 0.05;
        const AdaptiveResult result = rendered(busy, options);
        CHECK(result.seconds < 2);
        CHECK(result.samples > size * size);
    }
    SECTION("time, in the middle of a pass") {
        std::atomic<int> asked{0};
        const auto slow = [&asked](float, float) {
            if (++asked > size * size) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return grey(uniform());
        };
        options.timeLimit = 0.1;
        options.render.tileSize = 2;
        CHECK(rendered(slow, options).seconds < 1);
    }
    SECTION("caller") {
        options.keepGoing = [&](const AdaptiveProgress& progress) {
            seen.push_back(progress);
            return seen.size() < 8;
        };
        const AdaptiveResult result = rendered(busy, options);
        CHECK(result.passes == 8);
        CHECK(result.samples == seen.back().samples);
        for (std::size_t i = 1; i < seen.size(); ++i) CHECK(seen[i].samples >= seen[i - 1].samples);
        CHECK(seen.back().estimatedRmse < seen.front().estimatedRmse);
    }
}

TEST_CASE("differences above white are not refined", "[adaptive]") {
    const AdaptiveResult result =
        rendered([](float x, float) { return grey(x < 30.5f ? 3.f : 9.f); }, tolerance(0.01f));
    CHECK(sumOf(result.sampleCounts) < size * size + 3000);
    CHECK(result.estimatedRmse < 0.01);
}

TEST_CASE("radiance that is not finite is not refined without end", "[adaptive]") {
    const float value = GENERATE(std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity(), 3e38f, -3e38f);
    CAPTURE(value);
    const bool everywhere = GENERATE(true, false);
    const AdaptiveResult result =
        rendered([=](float x, float) { return grey(everywhere || x < 20.5f ? value : 0.5f); },
                 tolerance(0.01f));
    CHECK(result.samples < 60 * size * size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            CHECK((result.errors.at(x, y)[0] >= 0 && result.errors.at(x, y)[0] <= 1));
    if (!everywhere) CHECK(distance(result.image.at(40, 40), Vec3(0.5f, 0.5f, 0.5f)) < 1e-6);
}

TEST_CASE("an exception from radiance is passed on", "[adaptive]") {
    const Radiance thrower = [](float x, float y) -> Color {
        if (x > 30 && y > 30) throw std::runtime_error("no colour here");
        return {};
    };
    CHECK_THROWS_WITH(rendered(thrower, tolerance(0.01f, 2)), "no colour here");
}

TEST_CASE("a picture of one pixel is fine", "[adaptive]") {
    const AdaptiveResult result = renderAdaptive({0, 0, 1, 1}, 1, 1, busy, tolerance(0.01f));
    CHECK(result.samples >= 1);
}
