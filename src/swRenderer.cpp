#include "swRenderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>
#include <utility>

#include "swErrorEstimate.h"
#include "swSampling.h"
#include "swThreads.h"

namespace sw {
namespace {

class TileRenderer {
public:
    TileRenderer(const Window& window, const std::function<Color(int, int)>& radiance,
                 const RenderOptions& options)
        : window(window),
          radiance(radiance),
          options(options),
          tileSize(std::max(1, options.tileSize)),
          columns((window.width() + tileSize - 1) / tileSize),
          tiles(columns * ((window.height() + tileSize - 1) / tileSize)),
          result{.image = Image(window.width(), window.height()),
                 .errors = Image(window.width(), window.height()),
                 .rays = {}} {}

    RenderResult run() {
        const auto start = std::chrono::steady_clock::now();
        result.threads = onThreads(threadCount(), [this] { work(); });

        const double side = std::max(1, options.samples);
        estimateRmse();
        result.samples = static_cast<std::uint64_t>(side * side * window.width() * window.height());
        result.complete = done == tiles;
        result.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return std::move(result);
    }

private:
    int threadCount() const {
        const int hardware = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        const int wanted = options.threads > 0 ? options.threads : hardware;
        return std::clamp(wanted, 1, std::max(1, tiles));
    }

    // The work of one thread: it renders tiles until none is left, or one fails.
    void work() {
        takeRayCount();  // forgets what the calling thread traced before
        try {
            PixelSamples samples(options.pattern, options.samples);
            const StopScope scope(options.stop);
            for (int tile = next++; tile < tiles; tile = next++) {
                renderTile(tile, samples);
                finishTile(tile);
            }
        } catch (const Stopped&) {
            next = tiles;
        } catch (...) {
            next = tiles;
            throw;
        }
        const std::lock_guard lock(mutex);
        result.rays += takeRayCount();
    }

    Window place(int tile) const {
        const int left = window.x0 + tile % columns * tileSize;
        const int top = window.y0 + tile / columns * tileSize;
        return {left, top, std::min(left + tileSize, window.x1),
                std::min(top + tileSize, window.y1)};
    }

    void renderTile(int tile, PixelSamples& samples) {
        const Window part = place(tile);
        for (int y = part.y0; y < part.y1; ++y) {
            for (int x = part.x0; x < part.x1; ++x) {
                checkStop(x, y, options.samples * options.samples);
                seedPixel(options.seed, x, y);
                Color& pixel = result.image.at(x - window.x0, y - window.y0);
                pixel = radiance(x, y);
                result.errors.at(x - window.x0, y - window.y0) = samples.takeError(pixel);
            }
        }
    }

    // A pixel's estimated squared error may be wrong by its own size, all of them by a third.
    void estimateRmse() {
        double sum = 0, squares = 0;
        for (int y = 0; y < window.height(); ++y)
            for (int x = 0; x < window.width(); ++x) {
                const Color& error = result.errors.at(x, y);
                const double squared = error * error / 3;
                sum += squared;
                squares += squared * squared;
            }
        result.estimatedRmse = std::sqrt(sum / window.width() / window.height());
        result.estimatedRmseStandardError =
            result.estimatedRmse / 2 * std::sqrt(squares / (sum * sum) + 1. / 9);
    }

    void finishTile(int tile) {
        const std::lock_guard lock(mutex);
        ++done;
        if (options.preview)
            options.preview(place(tile), [this](int x, int y) {
                return result.image.at(x - window.x0, y - window.y0);
            });
        if (options.progress) options.progress(done, tiles);
    }

    const Window window;
    const std::function<Color(int, int)>& radiance;
    const RenderOptions& options;
    const int tileSize, columns, tiles;
    RenderResult result;  // every thread writes the pixels of its tiles

    std::atomic<int> next{0};
    std::mutex mutex;  // guards result.rays and what follows
    int done = 0;
};

}  // namespace

RenderResult render(const Window& window, const std::function<Color(int x, int y)>& radiance,
                    const RenderOptions& options) {
    return TileRenderer(window, radiance, options).run();
}

}  // namespace sw
