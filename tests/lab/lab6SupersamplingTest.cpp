#include "lab/samplePlaces.h"

using namespace lab;
using namespace sw;

// Where samplePixel() takes its samples.

namespace {

std::string gridOf(int n) {
    return "samplePixel() with n = " + std::to_string(n);
}

std::string text(const Range& range) {
    return lab::text(range.low) + " to " + lab::text(range.high);
}

void expectRightCount(const Samples& samples) {
    if (!wrongCount(samples)) return;
    const int n = samples.n;
    fail({gridOf(n), std::to_string(samples.pixels[0].size()) + " rays",
          std::to_string(n * n) + " rays", countHint(samples)});
}

}  // namespace

TEST_CASE("a pixel of n times n samples asks for so many rays", "[lab6]") {
    for (const int n : {2, 3, 4, 8}) expectRightCount(manySamples(n));
}

TEST_CASE("every cell of the grid holds one sample", "[lab6]") {
    for (const int n : {2, 3, 4, 8}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        for (int cell = 0; cell < n * n; ++cell) {
            const float width = 1 / static_cast<float>(n);
            const float left = static_cast<float>(cell % n) * width - rounding;
            const float top = static_cast<float>(cell / n) * width - rounding;
            const float size = width + 2 * rounding;
            for (const auto& pixel : samples.pixels) {
                if (std::any_of(pixel.begin(), pixel.end(), [&](const Sample& s) {
                        return s.x >= left && s.x <= left + size && s.y >= top && s.y <= top + size;
                    }))
                    continue;
                fail({gridOf(n) + ": the cell in column " + std::to_string(cell % n) + ", row " +
                          std::to_string(cell / n) + " of 0.." + std::to_string(n - 1),
                      "no sample in it", "one sample", placeHint(samples)});
            }
        }
    }
}

TEST_CASE("no sample leaves its pixel", "[lab6]") {
    for (const int n : {2, 3, 5}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        if (share(samples, leavesPixel) == 0) continue;
        fail({gridOf(n),
              "samples from " + text(coverage(samples, &Sample::x).pixel) + " in x and from " +
                  text(coverage(samples, &Sample::y).pixel) + " in y, in pixels from the corner",
              "from 0 to 1", placeHint(samples)});
    }
}

TEST_CASE("samples reach from one edge of their cells to the other", "[lab6]") {
    // On each axis 2000 samples or more. That none of them lies in the first three hundredths of
    // its cell, or none in the last three, happens once in 10 ^ 26 runs.
    for (const int n : {2, 3, 5}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        for (const auto axis : {&Sample::x, &Sample::y}) {
            const Coverage c = coverage(samples, axis);
            if (c.isWhole() && !isPattern(samples)) continue;
            fail({gridOf(n) + (axis == &Sample::x ? ", in x" : ", in y"),
                  "samples from " + text(c.pixel) + " in the pixel and from " + text(c.cell) +
                      " in their cells",
                  "from 0 to 1, everywhere in between", placeHint(samples)});
        }
    }
}

TEST_CASE("where a sample lies in its row does not tell where in its column", "[lab6]") {
    // A cell in 4 x 4 parts, 125 samples or more in each on average: for all of some 2000 to miss
    // one of them is as likely as (15 / 16) ^ 2000, less than 10 ^ -55.
    constexpr int parts = 4;
    for (const int n : {2, 3}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        if (share(samples, leavesPixel) > 0)
            fail({gridOf(n), "samples beyond the pixel", "samples in the pixel",
                  placeHint(samples)});
        std::vector<bool> reached(parts * parts, false);
        share(samples, [&](const Sample& s) {
            const auto part = [&](float c) {
                return static_cast<std::size_t>(inCell(c, n) * 0.99999f * parts);
            };
            return reached[part(s.x) * parts + part(s.y)] = true;
        });
        const auto missed = std::count(reached.begin(), reached.end(), false);
        if (missed == 0) continue;
        fail({gridOf(n) + ": the cells in 4 x 4 parts",
              std::to_string(missed) + " of the 16 parts never hold a sample",
              "samples in all parts", placeHint(samples)});
    }
}

TEST_CASE("each sample has random numbers of its own", "[lab6]") {
    // Two of 2000 pairs or more agree by chance in 1 of 250 cases; a tenth of them never do.
    for (const int n : {2, 3}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        const float shared = sharedNumbers(samples);
        if (shared < 0.1f) continue;
        fail({gridOf(n),
              "two of a pixel's samples share a coordinate within their cells in " +
                  lab::text(100 * shared) + " % of all cases",
              "next to never", placeHint(samples)});
    }
}
