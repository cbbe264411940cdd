#pragma once

#include "lab/sampleCounts.h"
#include "lab/sampleFormulas.h"

/// What is wrong with the places of samples.
namespace lab {

inline bool leavesPixel(const Sample& s) {
    const float low = -rounding, high = 1 + rounding;
    return !(s.x >= low && s.x <= high && s.y >= low && s.y <= high);
}

/// Whether two parts of a cell are the same; the end of one cell is the beginning of the next.
inline bool samePart(float a, float b) {
    const float apart = std::fabs(a - b);
    return std::min(apart, 1 - apart) < 0.001f;
}

inline bool wrongCount(const Samples& samples) {
    const auto expected = static_cast<std::size_t>(samples.n * samples.n);
    return std::any_of(samples.pixels.begin(), samples.pixels.end(), [&](const Pixel& pixel) {
        return pixel.endless || pixel.lost > 0 || pixel.samples.size() != expected;
    });
}

inline bool samePlaces(const Pixel& a, const Pixel& b) {
    return std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                      [](const Sample& s, const Sample& t) {
                          return std::fabs(s.x - t.x) + std::fabs(s.y - t.y) < 1e-4f;
                      });
}

/// Whether the samples lie at the same places in all pixels.
inline bool isPattern(const Samples& samples) {
    return std::all_of(samples.pixels.begin(), samples.pixels.end(),
                       [&](const Pixel& pixel) { return samePlaces(pixel, samples.pixels[0]); });
}

/// Whether each pixel has its samples at the same places whatever its seed.
inline bool isSeedless(const Samples& samples) {
    const auto& pixels = samples.pixels;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (pixels[i].x == pixels[j].x && pixels[i].y == pixels[j].y &&
                !samePlaces(pixels[i], pixels[j]))
                return false;
    return true;
}

/// The fraction of pairs of samples in one pixel that lie alike in their cells, in x or in y.
inline float sharedNumbers(const Samples& samples) {
    const int n = samples.n;
    float shared = 0, pairs = 0;
    for (const Pixel& pixel : samples.pixels)
        for (std::size_t i = 0; i < pixel.samples.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Sample &a = pixel.samples[i], &b = pixel.samples[j];
                ++pairs;
                shared += samePart(inCell(a.x, n), inCell(b.x, n)) ||
                          samePart(inCell(a.y, n), inCell(b.y, n));
            }
    return pairs > 0 ? shared / pairs : 0;
}

/// The smallest and the largest of some numbers.
struct Range {
    float low = 2, high = -2;
    void add(float x) { low = std::min(low, x), high = std::max(high, x); }
    /// From 0 to 1, as far as chance tells.
    bool isWhole() const { return low < 0.03f && high > 0.97f; }
};

/// Where the samples lie along one axis, in the pixel and in their cells.
struct Coverage {
    Range pixel, cell;
    bool isWhole() const { return pixel.isWhole() && cell.isWhole(); }
};

/// Where the end of one cell, but for rounding, is the beginning of the next.
inline Coverage coverage(const Samples& samples, float Sample::*axis) {
    Coverage c;
    for (const Pixel& pixel : samples.pixels)
        for (const Sample& s : pixel.samples) {
            c.pixel.add(s.*axis);
            const float part = inCell(s.*axis, samples.n);
            c.cell.add(part > 0.9999f ? 0 : part);
        }
    return c;
}

/// Whether each sample lies in the pixel that has x and y exchanged.
inline bool axesAreSwapped() {
    return allFew([](const Samples& samples) {
        return std::all_of(samples.pixels.begin(), samples.pixels.end(), [](const Pixel& p) {
            const float turn = static_cast<float>(p.x - p.y);
            return std::none_of(p.samples.begin(), p.samples.end(), [&](const Sample& s) {
                return leavesPixel({s.x + turn, s.y - turn});
            });
        });
    });
}

/// Numbers that are not random, or too few.
inline std::string randomHint() {
    if (allFew(isPattern) && !isWithoutNumbers())
        return "the samples lie at the same places in every pixel, whatever its seed, as if random "
               "numbers began anew each time: those of uniform() go on";
    if (allFew(isSeedless) && !allFew(isPattern))
        return "a pixel has its samples at the same places whatever its seed: the renderer seeds "
               "uniform() for each pixel";
    return "";
}

/// Samples that share numbers.
inline std::string sharingHint() {
    if (allFew([](const Samples& samples) {
            return all(samples, [&](const Sample& s) {
                return samePart(inCell(s.x, samples.n), inCell(s.y, samples.n));
            });
        }))
        return "one random number is used for both axes, so all samples lie on the diagonals of "
               "their cells: draw one for x and another one for y";
    const bool fromUniform = isRight(&Sample::x) && isRight(&Sample::y);
    if (fromUniform && allFew([](const Samples& samples) { return sharedNumbers(samples) > 0.1f; }))
        return "several samples of a pixel share a random number: draw new ones for every sample, "
               "in the innermost loop";
    return "";
}

/// Samples in the right pixel that do not reach everywhere.
inline std::string coverageHint() {
    for (const int n : {2, 3, 5}) {
        const Samples samples = manySamples(n);
        if (coverage(samples, &Sample::x).cell.isWhole() &&
            coverage(samples, &Sample::y).cell.isWhole())
            return "";
    }
    return "the samples cover only part of each cell: a random number between 0 and 1 reaches from "
           "one edge of the cell to the other";
}

/// The cells on the diagonal, and no others.
inline bool onDiagonal() {
    return allFew([](const Samples& samples) {
        const float n = static_cast<float>(samples.n);
        return all(samples, [&](const Sample& s) {
            return std::floor(s.x * n * 0.99999f) == std::floor(s.y * n * 0.99999f);
        });
    });
}

/// Samples that are right in number, and each in the pixel.
inline std::string placeInPixelHint() {
    const auto isSound = [](const Samples& samples) {
        return !wrongCount(samples) &&
               all(samples, [](const Sample& s) { return !leavesPixel(s); });
    };
    if (!allFew(isSound)) return "";
    if (onDiagonal())
        return "all samples lie in the cells of the diagonal: rows and columns are counted "
               "independently of each other";
    const std::string hint = sharingHint();
    return hint.empty() ? coverageHint() : hint;
}

inline std::string placeHint() {
    const auto tellsNothing = [](const Pixel& pixel) {
        return pixel.samples.empty() || pixel.endless;
    };
    if (!allFew([&](const Samples& samples) {
            return std::none_of(samples.pixels.begin(), samples.pixels.end(), tellsNothing);
        }))
        return "";
    if (axesAreSwapped())
        return "the samples lie in pixel (y, x): the camera takes x, to the right, before y";
    const bool onePoint = allCounts([](const Count& c) { return found(c) == 1; });
    if (onePoint && !isWithoutNumbers())
        return "all rays of a pixel go through the same point: each cell has a point of its own";
    for (const auto find : {randomHint, formulaHint, placeInPixelHint})
        if (const std::string hint = find(); !hint.empty()) return hint;
    return "";
}

/// The known mistake that explains the number and the places of all samples; empty if there is
/// none, and where all is well.
inline std::string sampleHint() {
    if (!allFew([](const Samples& samples) {
            return std::all_of(samples.pixels.begin(), samples.pixels.end(),
                               [](const Pixel& pixel) { return pixel.lost == 0; });
        }))
        return "the camera is asked for a place that is NaN or infinite, as a division by 0 makes "
               "it";
    const std::string hint = countHint();
    return hint.empty() ? placeHint() : hint;
}

}  // namespace lab
