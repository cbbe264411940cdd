#include "lab/record.h"
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

std::string countOf(const Pixel& pixel) {
    if (pixel.endless) return "rays without end";
    const std::string rays = std::to_string(pixel.rays.size()) + " rays";
    return pixel.lost > 0 ? rays + ", some in no direction: NaN"
                          : rays + " to " + std::to_string(pixel.samples.size()) +
                                (pixel.samples.size() == 1 ? " place" : " places");
}

void expectRightCount(const Pixel& pixel, int n) {
    const auto expected = static_cast<std::size_t>(n * n);
    if (!pixel.endless && pixel.lost == 0 && pixel.samples.size() == expected) return;
    fail({gridOf(n) + " for pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) +
              ")",
          countOf(pixel), std::to_string(n * n) + " rays, each to a place of its own",
          sampleHint()});
}

void expectRightCount(const Samples& samples) {
    for (const Pixel& pixel : samples.pixels) expectRightCount(pixel, samples.n);
}

// No mistake, as the picture is right, but a note in the report.
void noteIfSlow(const Count& count) {
    const Ray& ray = count.pixel.primary[0];
    const std::size_t needed = found(count) * raysFor(skyScene(), ray, 3);
    if (count.pixel.rays.size() < 2 * needed) return;
    running().got = "right but slow: " + std::to_string(count.pixel.rays.size()) + " rays for " +
                    std::to_string(found(count)) + " samples";
}

}  // namespace

TEST_CASE("a pixel of n times n samples asks for so many rays", "[lab6]") {
    for (const Count& count : counts()) {
        expectRightCount(count.pixel, count.n);
        noteIfSlow(count);
    }
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
            for (const Pixel& pixel : samples.pixels) {
                if (std::any_of(pixel.samples.begin(), pixel.samples.end(), [&](const Sample& s) {
                        return s.x >= left && s.x <= left + size && s.y >= top && s.y <= top + size;
                    }))
                    continue;
                fail({gridOf(n) + ": the cell in column " + std::to_string(cell % n) + ", row " +
                          std::to_string(cell / n) + " of 0.." + std::to_string(n - 1),
                      "no sample in it", "one sample", sampleHint()});
            }
        }
    }
}

TEST_CASE("no sample leaves its pixel", "[lab6]") {
    for (const int n : {2, 3, 5}) {
        const Samples samples = manySamples(n);
        expectRightCount(samples);
        if (all(samples, [](const Sample& s) { return !leavesPixel(s); })) continue;
        fail({gridOf(n),
              "samples from " + text(coverage(samples, &Sample::x).pixel) + " in x and from " +
                  text(coverage(samples, &Sample::y).pixel) + " in y, in pixels from the corner",
              "from 0 to 1", sampleHint()});
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
                  "from 0 to 1, everywhere in between", sampleHint()});
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
        if (!all(samples, [](const Sample& s) { return !leavesPixel(s); }))
            fail({gridOf(n), "samples beyond the pixel", "samples in the pixel", sampleHint()});
        std::vector<bool> reached(parts * parts, false);
        const auto part = [&](float c) {
            return static_cast<std::size_t>(inCell(c, n) * 0.99999f * parts);
        };
        for (const Pixel& pixel : samples.pixels)
            for (const Sample& s : pixel.samples) reached[part(s.x) * parts + part(s.y)] = true;
        const auto missed = std::count(reached.begin(), reached.end(), false);
        if (missed == 0) continue;
        fail({gridOf(n) + ": the cells in 4 x 4 parts",
              std::to_string(missed) + " of the 16 parts never hold a sample",
              "samples in all parts", sampleHint()});
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
              "next to never", sampleHint()});
    }
}
