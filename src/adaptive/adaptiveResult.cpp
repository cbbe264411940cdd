#include "adaptive/adaptiveResult.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "adaptive/tiles.h"
#include "swThreads.h"

namespace sw {
namespace {

// Where a pixel is in the window, row by row.
std::size_t placeOf(const Window& window, int x, int y) {
    return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
           static_cast<std::size_t>(x - window.x0);
}

void put(RenderResult& result, int x, int y, const Color& color, float squaredError) {
    const float error = std::sqrt(squaredError);
    result.image.at(x, y) = color;
    result.errors.at(x, y) = Color(error, error, error);
}

std::uint64_t roughPixels(const std::vector<int>& sampleCounts) {
    return static_cast<std::uint64_t>(std::count(sampleCounts.begin(), sampleCounts.end(), 0));
}

}  // namespace

void makeBlank(const SampledPicture& picture, const Window& window) {
    std::atomic<int> next{0};
    // Several threads get memory from the system faster than one.
    onThreads(window.width() > 2'000'000 / window.height() ? 2 : 1, [&] {
        for (int part = next++; part < 3; part = next++) {
            if (part == 0) picture.result.image = Image(window.width(), window.height());
            if (part == 1) picture.result.errors = Image(window.width(), window.height());
            if (part == 2) picture.sampleCounts.resize(placeOf(window, window.x0, window.y1));
        }
    });
}

double estimatedRmse(const AdaptiveGrid& grid, const Window& window) {
    double sum = 0;
    forEachPixel(window, [&](int x, int y) { sum += grid.squaredErrorOf(x, y); });
    return std::sqrt(sum / window.width() / window.height());
}

void fill(const SampledPicture& picture, const AdaptiveGrid& grid, const Window& window,
          const RenderOptions& options) {
    RenderResult& result = picture.result;
    forEachTile(window, options, [&](const Window& tile) {
        forEachPixel(tile, [&](int x, int y) {
            put(result, x - window.x0, y - window.y0, grid.color(x, y), grid.squaredErrorOf(x, y));
            const AdaptivePixel& pixel = grid.pixel(x, y);
            picture.sampleCounts[placeOf(window, x, y)] = pixel.isRough() ? 0 : pixel.samples;
        });
    });
    result.estimatedRmse = estimatedRmse(grid, window);
    result.samples = grid.samples();
    result.rays += grid.rays();
    result.threads = grid.threads();
    result.roughPixels = roughPixels(picture.sampleCounts);
}

void fill(const SampledPicture& picture, const CoarsePicture& coarse, const Window& window,
          const RenderOptions& options) {
    RenderResult& result = picture.result;
    RenderOptions how = options;
    how.tileSize = 256;  // so that few pages of memory are in use at once
    std::mutex mutex;
    double squares = 0;
    forEachTile(window, how, [&](const Window& tile) {
        double ofTile = 0;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1;) {
                // Errors of single pixels are not worth their time.
                const int end = std::min(x + std::max(coarse.runFrom(x), 4), tile.x1);
                const float squaredError = coarse.squaredErrorAt(x, y);
                ofTile += (end - x) * static_cast<double>(squaredError);
                for (; x < end; ++x) {
                    put(result, x - window.x0, y - window.y0, coarse.at(x, y).color, squaredError);
                    picture.sampleCounts[placeOf(window, x, y)] = coarse.isSampled(x, y);
                }
            }
        }
        const std::lock_guard lock(mutex);
        squares += ofTile;
    });
    result.estimatedRmse = std::sqrt(squares / window.width() / window.height());
    result.samples = coarse.samples();
    result.rays += coarse.rays();
    result.threads = coarse.threads();
    result.roughPixels = roughPixels(picture.sampleCounts);
}

}  // namespace sw
