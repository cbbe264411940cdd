#include "adaptive/adaptiveResult.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "adaptive/tiles.h"

namespace sw {
namespace {

// Where a pixel is in the window, row by row.
std::size_t placeOf(const Window& window, int x, int y) {
    return static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
           static_cast<std::size_t>(x - window.x0);
}

/// All but the colour is a detail.
struct PixelResult {
    Color color;
    float squaredError = 0;
    int samples = 0;  ///< 0: a rough one
};

void put(const SampledPicture& picture, const Window& window, int x, int y,
         const PixelResult& pixel) {
    picture.result.image.at(x - window.x0, y - window.y0) = pixel.color;
    if (!picture.details) return;
    const float error = std::sqrt(pixel.squaredError);
    picture.result.errors.at(x - window.x0, y - window.y0) = Color(error, error, error);
    picture.sampleCounts[placeOf(window, x, y)] = pixel.samples;
}

// How long it takes to use new memory. The median of several tries counts: other programs may come
// in between.
double secondsPerByte(Image& image) {
    constexpr int few = 700'000, tries = 9;  // some 8 MB
    const int rows = std::clamp(few / tries / image.width(), 1, image.height() / 16 / tries + 1);
    std::vector<double> seconds;
    for (int y = 0; y + rows <= image.height() && y < tries * rows; y += rows) {
        const auto start = Clock::now();
        for (int i = 0; i < rows; ++i)
            for (int x = 0; x < image.width(); ++x) image.at(x, y + i) = Color();
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle / (static_cast<double>(sizeof(Color)) * rows * image.width());
}

}  // namespace

double makeBlank(const SampledPicture& picture, const Window& window) {
    picture.result.image = Image(window.width(), window.height());
    if (picture.details) {
        picture.result.errors = Image(window.width(), window.height());
        picture.sampleCounts.resize(placeOf(window, window.x0, window.y1));
    }
    return secondsPerByte(picture.result.image);
}

double estimatedRmse(const AdaptiveGrid& grid, const Window& window) {
    double sum = 0;
    forEachPixel(window, [&](int x, int y) { sum += grid.wholeErrorOf(x, y); });
    return std::sqrt(sum / window.width() / window.height());
}

void fill(const SampledPicture& picture, const AdaptiveGrid& grid, const Window& window,
          const RenderOptions& options) {
    RenderResult& result = picture.result;
    std::atomic<std::uint64_t> rough{0};
    forEachTile(window, options, [&](const Window& tile) {
        std::uint64_t ofTile = 0;
        forEachPixel(tile, [&](int x, int y) {
            const AdaptivePixel& pixel = grid.pixel(x, y);
            const int samples = pixel.isRough() ? 0 : pixel.samples;
            put(picture, window, x, y, {grid.color(x, y), grid.ownErrorOf(x, y), samples});
            ofTile += samples == 0;
        });
        rough += ofTile;
    });
    result.estimatedRmse = estimatedRmse(grid, window);
    result.samples = grid.samples();
    result.rays += grid.rays();
    result.threads = grid.threads();
    result.roughPixels = rough;
}

void fill(const SampledPicture& picture, const CoarsePicture& coarse, const Window& window,
          const RenderOptions& options) {
    RenderResult& result = picture.result;
    RenderOptions how = options;
    how.tileSize = 256;  // so that few pages of memory are in use at once
    std::mutex mutex;
    double squares = 0;
    std::uint64_t rough = 0;
    forEachTile(window, how, [&](const Window& tile) {
        double ofTile = 0;
        std::uint64_t roughOfTile = 0;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1;) {
                // Errors of single pixels are not worth their time.
                const int end = std::min(x + std::max(coarse.runFrom(x), 4), tile.x1);
                const float squaredError = coarse.squaredErrorAt(x, y);
                ofTile += (end - x) * static_cast<double>(squaredError);
                for (; x < end; ++x) {
                    const bool sampled = coarse.isSampled(x, y);
                    put(picture, window, x, y, {coarse.at(x, y).color, squaredError, sampled});
                    roughOfTile += !sampled;
                }
            }
        }
        const std::lock_guard lock(mutex);
        squares += ofTile;
        rough += roughOfTile;
    });
    result.estimatedRmse = std::sqrt(squares / window.width() / window.height());
    result.samples = coarse.samples();
    result.rays += coarse.rays();
    result.threads = coarse.threads();
    result.roughPixels = rough;
}

}  // namespace sw
