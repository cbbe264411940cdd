#include "app/sampling.h"

#include "swAdaptive.h"
#include "swCorners.h"
#include "swMetrics.h"
#include "swSamplePattern.h"

std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const sw::RenderOptions& how,
    const std::function<sw::Color(float x, float y)>& radiance) {
    const SamplingOptions& sampling = options.sampling;
    if (sampling.isAdaptive()) {
        sw::AdaptiveOptions limits;
        limits.tolerance = sampling.tolerance;
        limits.targetRmse = sampling.targetRmse;
        limits.timeLimit = sampling.timeLimit;
        limits.render = how;
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

void writeErrorImage(const SamplingOptions& options, const sw::RenderResult& result) {
    if (!options.errorImage.empty()) sw::writePng(sw::heatMap(result.errors), options.errorImage);
}
