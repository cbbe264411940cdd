#include "swAdaptive.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "adaptive/adaptiveGrid.h"
#include "adaptive/pixelSequence.h"

namespace sw {
namespace {

// The thresholds of all passes but the first. A pixel with n samples is refined while its error is
// above both the tolerance and threshold * sqrt(n): errors e fall like n^-3/4, so one more sample
// lowers the sum of e^2 by about 1.5 e^2 / n. Samples are best spent where that is largest.
// Thresholds fall by a constant factor. With a tolerance, the list ends where thresholds are too
// small to matter, and then come passes that leave no error above the tolerance. The list depends
// on the tolerance alone: so the picture is independent of the window.
std::vector<float> thresholds(float tolerance) {
    constexpr float first = 0.05f, smallest = 1e-8f;
    const float ratio = tolerance > 0 ? 0.4f : 0.8f;
    constexpr int settlingPasses = 10;
    const float last = tolerance > 0 ? std::max(smallest, tolerance / 32) : smallest;
    std::vector<float> list;
    for (float threshold = first; threshold > last; threshold *= ratio) list.push_back(threshold);
    if (tolerance > 0) list.insert(list.end(), settlingPasses, 0.f);
    return list;
}

Window grown(const Window& window, int by) {
    return {window.x0 - by, window.y0 - by, window.x1 + by, window.y1 + by};
}

Window within(const Window& window, int width, int height) {
    return {std::max(window.x0, 0), std::max(window.y0, 0), std::min(window.x1, width),
            std::min(window.y1, height)};
}

class AdaptiveRenderer {
public:
    AdaptiveRenderer(const Window& window, int width, int height, const RadianceAt& radiance,
                     const AdaptiveOptions& options)
        : window(window),
          options(options),
          passThresholds(thresholds(options.tolerance)),
          margin(options.tolerance > 0 ? static_cast<int>(passThresholds.size()) + 1 : 1),
          grid(within(grown(window, margin), width, height), radiance, options.render) {}

    AdaptiveResult run() {
        grid.start();
        passes = 1;
        for (const float threshold : passThresholds) {
            if (limitReached()) break;
            pass(threshold);
        }
        return result();
    }

private:
    // The influence of a pixel in the margin moves only one pixel further with each pass to come.
    void pass(float threshold) {
        const float tolerance = std::max(0.f, options.tolerance);
        const int most = std::min(options.maxSamples, PixelSequence::length);
        grid.refineWhere(grown(window, std::max(0, margin - passes)),
                         {tolerance * tolerance, threshold * threshold, most},
                         [this] { return late(); });
        ++passes;
    }

    bool late() const { return options.timeLimit > 0 && seconds() >= options.timeLimit; }
    bool limitReached() const {
        if (late() || (options.targetRmse > 0 && rmse() <= options.targetRmse)) return true;
        return options.keepGoing && !options.keepGoing({passes, grid.samples(), rmse(), seconds()});
    }

    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    double rmse() const {
        double sum = 0;
        for (int y = window.y0; y < window.y1; ++y)
            for (int x = window.x0; x < window.x1; ++x) sum += grid.squaredErrorOf(x, y);
        return std::sqrt(sum / window.width() / window.height());
    }

    AdaptiveResult result() const {
        AdaptiveResult result{
            {Image(window.width(), window.height()), Image(window.width(), window.height()), rmse(),
             grid.samples(), grid.rays(), grid.threads(), seconds()},
            {},
            passes};
        for (int y = window.y0; y < window.y1; ++y) {
            for (int x = window.x0; x < window.x1; ++x) {
                result.image.at(x - window.x0, y - window.y0) = grid.color(x, y);
                const float error = std::sqrt(grid.squaredErrorOf(x, y));
                result.errors.at(x - window.x0, y - window.y0) = Color(error, error, error);
                result.sampleCounts.push_back(grid.pixel(x, y).samples);
            }
        }
        return result;
    }

    const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    const Window window;
    const AdaptiveOptions& options;
    const std::vector<float> passThresholds;
    const int margin;
    AdaptiveGrid grid;
    int passes = 0;
};

}  // namespace

AdaptiveResult renderAdaptive(const Window& window, int width, int height,
                              const std::function<Color(float x, float y)>& radiance,
                              const AdaptiveOptions& options) {
    return AdaptiveRenderer(window, width, height, radiance, options).run();
}

}  // namespace sw
