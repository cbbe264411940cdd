#include "app/sampling.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "app/options.h"
#include "swAdaptive.h"
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
}

void checkSamplingOptions(const CLI::App& app, const Options& options) {
    for (const char* way : {"--adaptive", "--target-rmse", "--time-limit"}) {
        if (app.count(way) == 0) continue;
        refuseBeside(app, way, {"--samples", "--sampler", "--corners"});
        if (!options.sampling.isAdaptive())
            throw UsageError(std::string(way) + ": expected a number, found NaN");
    }
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
    if (sampling.pattern == SamplePattern::jitter) return std::nullopt;
    const auto pixel = [&](int x, int y) {
        return sw::samplePixelWith(sampling.pattern, static_cast<float>(x), static_cast<float>(y),
                                   options.samples, radiance);
    };
    return sw::render(*options.crop, pixel, how);
}
