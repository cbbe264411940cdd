#include "adaptive/adaptivePixel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "adaptive/pixelSequence.h"
#include "swSampling.h"

namespace sw {
namespace {

/// 2^m samples, one in each cell of a pixel: columns x rows.
class Batch {
public:
    explicit Batch(int count) : cells(static_cast<std::size_t>(count)) {
        while (columns * rows < count) (columns > rows ? rows : columns) *= 2;
    }
    int count() const { return columns * rows; }
    void put(const SamplePoint& at, const Color& color) {
        const int column = static_cast<int>(at.x * static_cast<float>(columns));
        const int row = static_cast<int>(at.y * static_cast<float>(rows));
        cells[static_cast<std::size_t>(column * rows + row)] = color;
    }

    /// The differences of pairs of neighbouring cells.
    struct Differences {
        float meanSquare = 0;
        float largestSquare = 0;
    };
    Differences acrossColumns() const { return compare(static_cast<std::size_t>(rows), columns); }
    Differences acrossRows() const { return compare(1, rows); }

private:
    template <typename Function>
    void forEachPair(std::size_t step, const Function& function) const {
        for (std::size_t i = 0; i < cells.size(); i += 2 * step)
            for (std::size_t k = i; k < i + step; ++k) function(cells[k + step] - cells[k]);
    }

    // A smooth slope makes all pairs differ by the same amount, but strata integrate it almost
    // exactly: it must not count as error. Yet edges can look like slopes, steep ones above all. So
    // of a slope s (per pixel) only the share 1 / (1 + (s / 0.1)^2) is taken as smooth.
    Differences compare(std::size_t step, int cellsPerSide) const {
        const float pairs = static_cast<float>(cells.size() / 2);
        Color slope;
        forEachPair(step, [&](const Color& difference) { slope += difference; });
        slope *= 1 / pairs;
        const float perPixel = static_cast<float>(cellsPerSide) / 0.1f;
        const float smooth = 1 / (1 + square(slope) * perPixel * perPixel);
        slope *= smooth;

        Differences result;
        forEachPair(step, [&](const Color& difference) {
            const float d = square(difference - slope);
            result.meanSquare += d;
            if (d > result.largestSquare) result.largestSquare = d;
        });
        result.meanSquare /= pairs - smooth;  // the fitted slope costs that many degrees of freedom
        return result;
    }

    int columns = 1, rows = 1;
    std::vector<Color> cells;
};

// The variance of a mean of n stratified samples, from differences of neighbouring cells. Half the
// mean square of two samples' difference is the variance v in a stratum of two cells. An edge
// crosses a share of the strata that falls like n^-1/2, so the mean of n has c v (k/n)^1/2 / n for
// k strata of two cells. A (0, 2)-sequence does better than independent points in each stratum:
// measured over the lab scene, c = 0.54, from n = 4 to n = 256.
float varianceOfMean(const Batch::Differences& x, const Batch::Differences& y, int cells, int n) {
    const float v = 0.25f * (x.meanSquare + y.meanSquare);
    const float samples = static_cast<float>(n);
    return 0.54f * v * std::sqrt(0.5f * static_cast<float>(cells) / samples) / samples;
}

Color colorAt(const SamplePoint& p, int x, int y, const RadianceAt& radiance) {
    return radiance(static_cast<float>(x) + p.x, static_cast<float>(y) + p.y);
}

// Takes samples, all but the first, until there are `after`. Returns those of the last batch.
Batch takeSamples(AdaptivePixel& pixel, int x, int y, const RadianceAt& radiance,
                  const PixelSequence& sequence, int after) {
    const int before = pixel.samples;
    Batch batch(std::max(before, 4));
    if (before == 1) batch.put(sequence[0], pixel.mean);
    Color sum = static_cast<float>(before) * pixel.mean;
    for (int i = before; i < after; ++i) {
        const SamplePoint place = sequence[i];
        const Color color = colorAt(place, x, y, radiance);
        batch.put(place, color);
        sum += color;
    }
    pixel.mean = sum * (1 / static_cast<float>(after));
    pixel.x = pixel.y = 0.5f;
    pixel.samples = after;
    return batch;
}

}  // namespace

void refine(AdaptivePixel& pixel, int x, int y, const RadianceAt& radiance, std::uint64_t seed) {
    const PixelSequence sequence(seed, x, y);
    const int before = pixel.samples, after = refinedSamples(before);
    seedPixel(seed + static_cast<std::uint64_t>(before), x, y);
    if (before == 0) {
        const SamplePoint first = sequence[0];
        pixel.mean = colorAt(first, x, y, radiance);
        pixel.x = first.x;
        pixel.y = first.y;
        pixel.samples = after;
        return;
    }
    const Batch batch = takeSamples(pixel, x, y, radiance, sequence, after);
    const auto across = batch.acrossColumns(), down = batch.acrossRows();
    pixel.contrast = std::max({pixel.contrast, across.largestSquare, down.largestSquare});
    const float fresh = varianceOfMean(across, down, batch.count(), after);
    // The last estimate, scaled by 2^-3/2 for twice the samples, comes from half as many pairs.
    pixel.variance = before == 1 ? fresh : (2 * fresh + 0.354f * pixel.variance) / 3;
}

}  // namespace sw
