#include "app/sampling.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "app/options.h"
#include "swAdaptive.h"
#include "swCorners.h"
#include "swMetrics.h"
#include "swSamplePattern.h"

using sw::SamplePattern;

void addSamplingOptions(CLI::App& app, SamplingOptions& options) {
    const auto setPattern = [&options](const std::string& name) {
        const auto found = std::find(sw::patternNames.begin(), sw::patternNames.end(), name);
        options.pattern = static_cast<SamplePattern>(found - sw::patternNames.begin());
    };
    app.add_option_function<std::string>("--sampler", setPattern,
                                         "where they lie: jitter, grid, random or multijitter")
        ->check(CLI::IsMember(
            std::vector<std::string>(sw::patternNames.begin(), sw::patternNames.end())))
        ->default_str("jitter");
    const auto positive = CLI::Range(1e-9, 1e9);
    app.add_option("--adaptive", options.tolerance,
                   "as many samples as each pixel needs for this estimated error, 0.01 for example")
        ->check(positive);
    app.add_option("--target-rmse", options.targetRmse,
                   "the same, until this is the whole picture's estimated error")
        ->check(positive);
    app.add_option("--time-limit", options.timeLimit, "the same, for that many seconds")
        ->check(positive);
    app.add_flag("--corners", options.corners,
                 "rays at the corners of pixels, each shared by four, instead of samples");
    app.add_option("--error-image", options.errorImage,
                   "PNG of the estimated error: black 0.0001, blue 0.001, red 0.01, yellow 0.1, "
                   "white 1");
}

void checkSamplingOptions(const CLI::App& app, const Options& options) {
    const SamplingOptions& sampling = options.sampling;
    if (sampling.corners) refuseBeside(app, "--corners", {"--samples", "--sampler"});
    for (const char* way : {"--adaptive", "--target-rmse", "--time-limit"}) {
        if (app.count(way) == 0) continue;
        refuseBeside(app, way, {"--samples", "--sampler", "--corners"});
        if (!sampling.isAdaptive())
            throw UsageError(std::string(way) + ": expected a number, found NaN");
    }
    const bool oneSample = sampling.corners || (options.samples == 1 && !sampling.isAdaptive());
    if (!sampling.errorImage.empty() && oneSample)
        throw UsageError("--error-image: expected --samples 2 or more, found one sample per pixel");
}

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
    if (sampling.pattern == SamplePattern::jitter) return std::nullopt;
    const auto pixel = [&](int x, int y) {
        return sw::samplePixelWith(sampling.pattern, static_cast<float>(x), static_cast<float>(y),
                                   options.samples, radiance);
    };
    return sw::render(*options.crop, pixel, how);
}

void writeErrorImage(const SamplingOptions& options, const sw::RenderResult& result) {
    if (!options.errorImage.empty()) sw::writePng(sw::heatMap(result.errors), options.errorImage);
}
