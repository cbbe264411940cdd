#include "app/extraOptions.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "app/usage.h"

using sw::SamplePattern;

void addExtraOptions(CLI::App& app, ExtraOptions& options) {
    const auto setPattern = [&options](const std::string& name) {
        const auto found = std::find(sw::patternNames.begin(), sw::patternNames.end(), name);
        options.pattern = static_cast<SamplePattern>(found - sw::patternNames.begin());
    };
    app.add_option_function<std::string>("--sampler", setPattern,
                                         "sample pattern: jitter, grid, random or multijitter")
        ->check(CLI::IsMember(
            std::vector<std::string>(sw::patternNames.begin(), sw::patternNames.end())))
        ->default_str("jitter");
    const auto positive = CLI::Range(1e-9, 1e9);
    app.add_option(
           "--adaptive", options.tolerance,
           "adaptive: sample each pixel until its estimated error is at most this, e.g. 0.01")
        ->check(positive);
    app.add_option("--target-rmse", options.targetRmse,
                   "adaptive: stop when the picture's estimated error is at most this")
        ->check(positive);
    app.add_option("--time-limit", options.timeLimit, "adaptive: stop after this many seconds")
        ->check(positive);
    app.add_flag("--corners", options.corners,
                 "one ray per pixel corner, shared by four pixels, instead of samples");
    app.add_option("--stats", options.stats, "JSON file for ray counts, times and error");
    app.add_option("--error-image", options.errorImage,
                   "PNG of the estimated error: black 0.0001, blue 0.001, red 0.01, yellow 0.1, "
                   "white 1");
}

void checkExtraOptions(const CLI::App& app, const ExtraOptions& options, int samples) {
    if (options.corners) refuseBeside(app, "--corners", {"--samples", "--sampler"});
    for (const char* way : {"--adaptive", "--target-rmse", "--time-limit"}) {
        if (app.count(way) == 0) continue;
        refuseBeside(app, way, {"--samples", "--sampler", "--corners"});
        if (!options.isAdaptive())
            throw UsageError(std::string(way) + ": expected a number, found NaN");
    }
    const bool oneSample = options.corners || (samples == 1 && !options.isAdaptive());
    if (!options.errorImage.empty() && oneSample)
        throw UsageError("--error-image: expected --samples 2 or more, found one sample per pixel");
}
