#include "app/extraOptions.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/help.h"
#include "app/usage.h"
#include "app/validators.h"

using sw::SamplePattern;

namespace {

CLI::Validator patternName() {
    const auto check = [](const std::string& text) {
        const auto& names = sw::patternNames;
        if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
        return "expected jitter, grid, random or multijitter, found " +
               (text.empty() ? "nothing" : text);
    };
    return {check, ""};
}

}  // namespace

void addExtraOptions(CLI::App& app, ExtraOptions& options) {
    const auto setPattern = [&options](const std::string& name) {
        const auto found = std::find(sw::patternNames.begin(), sw::patternNames.end(), name);
        options.pattern = static_cast<SamplePattern>(found - sw::patternNames.begin());
    };
    app.add_option_function<std::string>("--sampler", setPattern,
                                         "sample pattern: jitter, grid, random or multijitter")
        ->transform(patternName())
        ->default_str("jitter");
    const auto addLimit = [&](const char* name, auto& value, const char* text) {
        app.add_option(name, value, text)->transform(number(1e-9, 1e9));
    };
    addLimit("--adaptive", options.tolerance,
             "sample each pixel until its estimated error is at most this, e.g. 0.01");
    addLimit("--target-rmse", options.targetRmse,
             "stop when the picture's estimated error, as an audit measures it, is at most this");
    addLimit("--time-limit", options.timeLimit, "stop after this many seconds");
    app.add_flag("--preview", options.preview,
                 "write the picture so far to the output file, every second");
    app.add_flag("--corners", options.corners,
                 "one ray per pixel corner, shared by four pixels, instead of samples");
    app.add_option("--stats", options.stats, "JSON file for ray counts, times and error")
        ->transform(fileName());
    app.add_option("--error-image", options.errorImage,
                   "PNG of the estimated error: black 0.0001, blue 0.001, red 0.01, yellow 0.1, "
                   "white 1")
        ->transform(fileName());
    app.add_option("--explore", options.explore,
                   "HTML page that shows the rays behind every pixel, and where they went")
        ->transform(fileName());
    app.add_flag("--force", options.force, "replace files that the program has not made");
    app.get_option("--output")->transform(fileName());
    arrangeHelp(app);
}

void checkExtraOptions(const CLI::App& app, const ExtraOptions& options, int samples) {
    refuseUnknown(app);
    if (options.corners) refuseBeside(app, "--corners", {"--samples", "--sampler"});
    for (const char* way : {"--adaptive", "--target-rmse", "--time-limit"})
        if (app.count(way) > 0) refuseBeside(app, way, {"--samples", "--sampler", "--corners"});
    const bool oneSample = options.corners || (samples == 1 && !options.isAdaptive());
    if (!options.errorImage.empty() && oneSample)
        throw UsageError("--error-image: expected --samples 2 or more, found one sample per pixel");
}
