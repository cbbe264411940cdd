#include "swAdaptive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "adaptive/adaptiveGrid.h"
#include "adaptive/adaptiveResult.h"
#include "adaptive/auditor.h"
#include "adaptive/coarsePicture.h"
#include "adaptive/passThresholds.h"
#include "adaptive/pixelSequence.h"
#include "adaptive/tiles.h"
#include "adaptive/timeShare.h"

namespace sw {
namespace {

// How far what an audit finds changes pixels: all of a block and those around it, and a few pixels
// more.
constexpr int feedBackPasses = 8;
constexpr int feedBackMargin = 2 * UnseenDetail::side + feedBackPasses;

std::chrono::nanoseconds inNanoseconds(double seconds) {
    return std::chrono::nanoseconds(static_cast<long long>(1e9 * seconds));
}

class AdaptiveRenderer {
public:
    AdaptiveRenderer(const Window& window, int width, int height, const RadianceAt& radiance,
                     const AdaptiveOptions& options)
        : window(window),
          options(options),
          width(width),
          height(height),
          radiance(radiance),
          thresholds(passThresholds(options.tolerance)),
          margin(options.tolerance > 0 ? static_cast<int>(thresholds.size()) + 1 + feedBackMargin
                                       : 1),
          region(within(grown(window, margin), width, height)),
          result{{.image = Image(1, 1), .errors = Image(1, 1), .rays = {}}, {}, {}} {
        secondsPerByte = makeBlank(picture, window);
    }

    AdaptiveResult run() {
        if (!isLimited() || timeSufficesForAll()) sampleAll();
        const bool onlyCoarse = coarse && passes == 0;
        if (onlyCoarse) fill(picture, *coarse, window, options.render);
        if (passes > 0) fill(picture, *grid, window, options.render);
        result.complete = onlyCoarse ? coarse->samples() > 0 : passes > 0;
        result.passes = passes;
        result.estimatedRmseStandardError = standardError;
        result.auditedPixels = auditor ? auditor->pixels() : 0;
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
        auditor.emplace(*grid, region, window, static_cast<double>(width) * height, radiance,
                        options.render.seed, ErrorLimits{options.tolerance, options.targetRmse});
        bool over = first.wasOver();
        if (!over && isLimited() && timeForAudit() < (options.timeLimit - seconds()) / 2)
            auditInBetween();
        for (const float threshold : thresholds) {
            if (over || limitReached(reserve())) break;
            TimeShare share = shareUntil(reserve());
            pass(threshold, share);
            over = share.wasOver();
        }
        auditAtLast(over);
    }

    // Time for the errors after a pass, to fill in the result, and to audit it.
    double reserve() const {
        return 2 * grid->secondsForErrors() + resultSeconds() + (isLimited() ? timeForAudit() : 0);
    }
    double timeForAudit() const {
        if (auditor->hasAudited()) return 1.3 * auditor->seconds();
        return 0.3 * firstPassSeconds + 2 * grid->secondsForErrors();
    }

    // What it has found leads the passes to come.
    void auditInBetween() {
        TimeShare share = shareUntil(resultSeconds());
        auditor->audit(share, !isLimited());
        if (!auditor->hasAudited()) return;
        // Of an estimate that sways, the low values end the rendering: so it must be lower.
        const Judgement found = auditor->found();
        const double most = static_cast<double>(options.targetRmse) * options.targetRmse;
        targetReached = found.squaredError + 0.5 * auditor->sway() <= most;
        if (!targetReached) auditor->feedBack();
    }

    void auditAtLast(bool over) {
        if (isStopped || (over && !isLimited())) return;
        TimeShare share = shareUntil(resultSeconds());
        // The last audit with a tolerance repairs nothing: whether there is one depends on the
        // window.
        bool repairs = true;
        if (options.tolerance > 0 && !isLimited() && !targetReached) {
            auditor->audit(share, false);
            if (!auditor->hasAudited()) return;
            repairs = false;
            const bool again = auditor->feedBackByBlocks(share);
            settlingPasses(share);
            if (again) auditor->audit(share, true);
        } else if (!targetReached) {
            auditor->audit(share, true);
        }
        if (!auditor->hasAudited()) return;
        auditor->settle(repairs);
        const double variance = auditor->found().variance, error = std::sqrt(variance);
        standardError = std::min(error / (2 * rmse()), std::sqrt(error));
    }

    // Until no error is above the tolerance that was below it before an audit.
    void settlingPasses(TimeShare& share) {
        reached = std::max(reached, margin - feedBackPasses);
        for (int i = 0; i < feedBackPasses && pass(0, share); ++i) {
        }
    }

    // The influence of a pixel in the margin moves only one pixel further with each pass to come:
    // what is `reached` of the margin needs no more samples.
    bool pass(float threshold, TimeShare& share) {
        const float tolerance = std::max(0.f, options.tolerance);
        const int most = std::min(options.maxSamples, PixelSequence::length);
        const bool any =
            grid->refineWhere(grown(window, std::max(0, margin - reached)),
                              {tolerance * tolerance, threshold * threshold, most}, share);
        ++passes;
        ++reached;
        return any;
    }

    bool limitReached(double reserve) {
        if (isLimited() && seconds() + reserve >= options.timeLimit) return true;
        // Often, the model's errors are too large.
        if (options.targetRmse > 0 && rmse() <= 2 * options.targetRmse &&
            static_cast<double>(grid->samples()) >
                1.3 * static_cast<double>(auditor->samplesAtModelAudit())) {
            TimeShare share = shareUntil(resultSeconds());
            auditor->auditModel(share);
        }
        if (options.targetRmse > 0 && rmse() <= options.targetRmse) {
            auditInBetween();
            if (targetReached) return true;
        } else if (isLimited() && auditor->hasAudited() &&
                   grid->samples() > 2 * auditor->samplesAtAudit()) {
            auditInBetween();
        }
        isStopped =
            options.keepGoing && !options.keepGoing({passes, grid->samples(), rmse(), seconds()});
        return isStopped;
    }
    double rmse() const { return estimatedRmse(*grid, window); }

    const Clock::time_point begin = Clock::now();
    const Window window;
    const AdaptiveOptions& options;
    const int width, height;
    const RadianceAt& radiance;
    const std::vector<float> thresholds;
    const int margin;
    const Window region;
    AdaptiveResult result;
    const SampledPicture picture{result, result.sampleCounts, options.details};
    double secondsPerByte = 0;  // to get memory from the system
    std::optional<CoarsePicture> coarse;
    double firstPassSeconds = 0;  // as expected from the coarse picture
    std::optional<AdaptiveGrid> grid;
    std::optional<Auditor> auditor;
    int passes = 0, reached = 1;
    bool isStopped = false, targetReached = false;
    double standardError = 0;
};

}  // namespace

AdaptiveResult renderAdaptive(const Window& window, int width, int height,
                              const std::function<Color(float x, float y)>& radiance,
                              const AdaptiveOptions& options) {
    return AdaptiveRenderer(window, width, height, radiance, options).run();
}

}  // namespace sw
