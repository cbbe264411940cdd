#include "adaptive/pixelSequence.h"

#include <set>
#include <utility>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

// In how many of columns x rows cells the points first, ..., first + columns * rows - 1 lie.
std::size_t cellsHit(const PixelSequence& sequence, int first, int columns, int rows) {
    std::set<std::pair<int, int>> cells;
    for (int i = first; i < first + columns * rows; ++i) {
        const SamplePoint p = sequence[i];
        cells.emplace(static_cast<int>(p.x * static_cast<float>(columns)),
                      static_cast<int>(p.y * static_cast<float>(rows)));
    }
    return cells.size();
}

}  // namespace

TEST_CASE("every block of 2^m points has one in each cell of every grid of 2^m cells",
          "[adaptive]") {
    const auto seed = GENERATE(range(0u, 20u));
    CAPTURE(seed);
    const PixelSequence sequence(seed, 3, 4);
    for (int count = 1; count <= 256; count *= 2)
        for (int first = 0; first < 1024; first += count)
            for (int columns = 1; columns <= count; columns *= 2)
                CHECK(cellsHit(sequence, first, columns, count / columns) ==
                      static_cast<std::size_t>(count));
}

TEST_CASE("points of a pixel lie in it, up to the last one", "[adaptive]") {
    const PixelSequence sequence(1, -5, 1000000);
    for (int i = 0; i < PixelSequence::length; ++i) {
        const SamplePoint p = sequence[i];
        CHECK((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
    }
}

TEST_CASE("first points of neighbouring pixels and seeds are independent", "[adaptive]") {
    constexpr int n = 200;
    double x = 0, y = 0, xx = 0, xy = 0, besides = 0, below = 0, seeds = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto centred = [](const SamplePoint& p) {
                return std::pair<double, double>(p.x - 0.5, p.y - 0.5);
            };
            const auto [a, b] = centred(PixelSequence(1, i, j)[0]);
            x += a, y += b, xx += a * a, xy += a * b;
            besides += a * centred(PixelSequence(1, i + 1, j)[0]).first;
            below += a * centred(PixelSequence(1, i, j + 1)[0]).first;
            seeds += a * centred(PixelSequence(2, i, j)[0]).first;
        }
    }
    // Each sum over n^2 independent products has a standard deviation of n / 12, or n / sqrt(12).
    CHECK(std::fabs(x) < 4 * n / std::sqrt(12));
    CHECK(std::fabs(y) < 4 * n / std::sqrt(12));
    CHECK(std::fabs(xx - n * n / 12.) < 4 * n * std::sqrt(1 / 180.));
    for (const double product : {xy, besides, below, seeds})
        CHECK(std::fabs(product) < 4 * n / 12.);
}
