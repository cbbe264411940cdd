#include "swAdaptive.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "adaptive/adaptiveGrid.h"
#include "adaptive/adaptiveResult.h"
#include "adaptive/coarsePicture.h"
#include "adaptive/pixelSequence.h"
#include "adaptive/timeShare.h"

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

std::chrono::nanoseconds inNanoseconds(double seconds) {
    return std::chrono::nanoseconds(static_cast<long long>(1e9 * seconds));
}

class AdaptiveRenderer {
public:
    AdaptiveRenderer(const Window& window, int width, int height, const RadianceAt& radiance,
                     const AdaptiveOptions& options)
        : window(window),
          options(options),
          radiance(radiance),
          passThresholds(thresholds(options.tolerance)),
          margin(options.tolerance > 0 ? static_cast<int>(passThresholds.size()) + 1 : 1),
          region(within(grown(window, margin), width, height)),
          result{{Image(1, 1), Image(1, 1), {}, {}, {}}, {}, {}} {
        secondsPerByte = makeBlank(picture, window);
    }

    AdaptiveResult run() {
        if (!isLimited() || timeSufficesForAll()) sampleAll();
        const bool onlyCoarse = coarse && passes == 0;
        if (onlyCoarse) fill(picture, *coarse, window, options.render);
        if (passes > 0) fill(picture, *grid, window, options.render);
        result.complete = onlyCoarse ? coarse->samples() > 0 : passes > 0;
        result.passes = passes;
        result.seconds = seconds();
        return std::move(result);
    }

private:
    bool isLimited() const { return options.timeLimit > 0; }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }

    // For a sweep that ends some seconds before the limit. Pixels that take too long may have a
    // sixteenth of its time together.
    TimeShare shareUntil(double reserve, double least = 0) const {
        if (!isLimited()) return TimeShare(options.render.stop);
        const double left = std::max(options.timeLimit - seconds() - reserve, least);
        return {options.render.stop, Clock::now() + inNanoseconds(left), left / 16};
    }

    // Makes the coarse picture finer until there is time for all pixels, or no more time. The first
    // level has some time in any case: there must be a picture. In the end, the result is filled
    // in.
    bool timeSufficesForAll() {
        coarse.emplace(region, radiance, options.render);
        do {
            const double start = seconds();
            const bool isFirst = coarse->side() == 0;
            TimeShare share = shareUntil(secondsToFill(), isFirst ? 0.05 : 0);
            coarse->addLevel(share);
            if (10 * resultSeconds() < options.timeLimit - seconds()) coarse->show();
            if (share.wasOver()) return false;
            // Pixels that are given up have a limit of their own, however many there are.
            const double wasted = share.secondsWasted() / coarse->threads();
            const double rest = std::max(seconds() - start - wasted, 0.0);
            firstPassSeconds = rest / static_cast<double>(coarse->samplesOfLevel()) *
                               (static_cast<double>(region.width()) * region.height());
            const double left = options.timeLimit - seconds();
            const double forWaste = wasted > 0 ? left / 16 : 0;
            // Estimates take time as well.
            if (1.3 * firstPassSeconds + memorySeconds(sizeof(AdaptivePixel)) + resultSeconds() +
                    forWaste <
                left)
                return true;
        } while (coarse->side() > 1 && hasTimeForNextLevel());
        return false;
    }

    // To get some bytes for every pixel of the region.
    double memorySeconds(std::size_t bytes) const {
        return secondsPerByte * static_cast<double>(bytes) * region.width() * region.height();
    }
    // To fill in the result. Memory takes most of it.
    double resultSeconds() const { return 1.5 * memorySeconds(picture.bytesPerPixel()); }
    // With the coarse picture's next level. A block's error takes at most a twentieth of a sample's
    // time.
    double secondsToFill() const {
        return resultSeconds() + firstPassSeconds / 20 / std::max(coarse->side() / 2, 1);
    }
    bool hasTimeForNextLevel() const {
        const double side = coarse->side() / 2;
        const double forBlocks = memorySeconds(sizeof(CoarsePicture::Block)) / (side * side);
        return seconds() + forBlocks + secondsToFill() < options.timeLimit;
    }

    void sampleAll() {
        grid.emplace(region, radiance, options.render);
        TimeShare first = shareUntil(0.3 * firstPassSeconds + resultSeconds());
        if (!grid->start(first, coarse ? &*coarse : nullptr)) return;
        passes = 1;
        bool over = first.wasOver();
        for (const float threshold : passThresholds) {
            // Time for the errors after the pass, and to fill in the result.
            const double reserve = 2 * grid->secondsForErrors() + resultSeconds();
            if (over || limitReached(reserve)) return;
            TimeShare share = shareUntil(reserve);
            pass(threshold, share);
            over = share.wasOver();
        }
    }

    // The influence of a pixel in the margin moves only one pixel further with each pass to come.
    void pass(float threshold, TimeShare& share) {
        const float tolerance = std::max(0.f, options.tolerance);
        const int most = std::min(options.maxSamples, PixelSequence::length);
        grid->refineWhere(grown(window, std::max(0, margin - passes)),
                          {tolerance * tolerance, threshold * threshold, most}, share);
        ++passes;
    }

    bool limitReached(double reserve) const {
        if (isLimited() && seconds() + reserve >= options.timeLimit) return true;
        if (options.targetRmse > 0 && rmse() <= options.targetRmse) return true;
        return options.keepGoing &&
               !options.keepGoing({passes, grid->samples(), rmse(), seconds()});
    }
    double rmse() const { return estimatedRmse(*grid, window); }

    const Clock::time_point begin = Clock::now();
    const Window window;
    const AdaptiveOptions& options;
    const RadianceAt& radiance;
    const std::vector<float> passThresholds;
    const int margin;
    const Window region;
    AdaptiveResult result;
    const SampledPicture picture{result, result.sampleCounts, options.details};
    double secondsPerByte = 0;  // to get memory from the system
    std::optional<CoarsePicture> coarse;
    double firstPassSeconds = 0;  // as expected from the coarse picture
    std::optional<AdaptiveGrid> grid;
    int passes = 0;
};

}  // namespace

AdaptiveResult renderAdaptive(const Window& window, int width, int height,
                              const std::function<Color(float x, float y)>& radiance,
                              const AdaptiveOptions& options) {
    return AdaptiveRenderer(window, width, height, radiance, options).run();
}

}  // namespace sw
