#include "app/extras.h"

#include <algorithm>

#include "app/explore/recording.h"
#include "app/outputs.h"
#include "app/statistics.h"
#include "files/target.h"
#include "swAdaptive.h"
#include "swCorners.h"
#include "swFile.h"
#include "swMetrics.h"
#include "swSamplePattern.h"

std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const StepTimes& spent, RenderWatch& watch,
    const std::function<sw::Color(float x, float y)>& radiance) {
    const ExtraOptions& sampling = options.extra;
    const sw::RenderOptions& how = watch.how();
    if (sampling.isAdaptive()) {
        sw::AdaptiveOptions limits;
        limits.tolerance = sampling.tolerance;
        limits.targetRmse = sampling.targetRmse;
        if (sampling.timeLimit > 0)
            limits.timeLimit = std::max(sampling.timeLimit - spent.total(), 1e-3);
        limits.details = !sampling.stats.empty() || !sampling.errorImage.empty();
        limits.render = how;
        if (watch.showsPasses())
            limits.keepGoing = [&](const auto& progress) { return watch.passDone(progress); };
        return sw::renderAdaptive(*options.crop, options.width, options.height, radiance, limits);
    }
    if (sampling.corners) {
        const auto corner = [&](int x, int y) {
            return radiance(static_cast<float>(x), static_cast<float>(y));
        };
        return sw::renderCorners(*options.crop, corner, how);
    }
    if (sampling.pattern == sw::SamplePattern::jitter) return std::nullopt;
    const auto pixel = [&](int x, int y) {
        return sw::samplePixelWith(sampling.pattern, static_cast<float>(x), static_cast<float>(y),
                                   options.samples, radiance);
    };
    return sw::render(*options.crop, pixel, how);
}

std::shared_ptr<const Recording> recordExtras(const Options& options, const sw::NffScene& file,
                                              std::vector<sw::NffShape> shapes,
                                              const rayTree::Trace& traceRay) {
    const std::filesystem::path& page = options.extra.explore;
    if (page.empty()) return nullptr;
    auto recording =
        std::make_shared<Recording>(recordRays(options, file, std::move(shapes), traceRay));
    if (recording->rays.endless > 0 && !sw::targetOf(page).stream)
        save(page, explorePage(options, file, *recording, sw::Image(1, 1)));
    return recording;
}

void writeExtras(const Options& options, const sw::RenderResult& result, const StepTimes& times,
                 const sw::NffScene& file, const Recording* recording, std::string failure) {
    const ExtraOptions& extra = options.extra;
    const auto heat = [&] { return sw::encodePng(sw::heatMap(result.errors)); };
    const auto statistics = [&] { return statsJson(options, result, times, file.scene); };
    const auto page = [&] { return explorePage(options, file, *recording, result.errors); };
    saveBeside(extra.errorImage, heat, failure);
    saveBeside(extra.stats, statistics, failure);
    if (recording) saveBeside(extra.explore, page, failure);
    if (!failure.empty()) throw sw::FileError(failure);
}
