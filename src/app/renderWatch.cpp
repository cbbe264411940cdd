#include "app/renderWatch.h"

#include <optional>

#include "app/console.h"
#include "app/interrupt.h"
#include "app/preview.h"
#include "app/progressBar.h"
#include "app/report.h"
#include "app/terminal.h"
#include "files/target.h"

namespace fs = std::filesystem;

namespace {

void requireFileForPreview(const fs::path& output) {
    const sw::Target target = sw::targetOf(output);
    if (target.stream || target.isSpecial())
        throw UsageError("--preview: expected a file as output, found " + output.string() +
                         " (the picture is written again and again)");
}

const char* signalName() {
    return InterruptNotice::signal() == SIGINT ? "SIGINT" : "SIGTERM";
}

}  // namespace

int Interrupted::exitCode() {
    return 128 + InterruptNotice::signal();
}

struct RenderWatch::Parts {
    InterruptNotice interrupt;
    std::optional<ProgressBar> bar;
    std::optional<Preview> preview;
    std::string whatIsLeft;  // if a signal ends a render without a complete picture
};

RenderWatch::RenderWatch(const Options& options, const sw::Color& background)
    : parts(std::make_unique<Parts>()) {
    const ExtraOptions& extra = options.extra;
    renderOptions.threads = options.threads;
    renderOptions.seed = options.seed;
    renderOptions.pattern = extra.pattern;
    renderOptions.samples = options.samples;
    if (!options.quiet) {
        parts->bar.emplace(extra.isAdaptive(), extra.timeLimit, extra.targetRmse);
        renderOptions.progress = [this](int done, int total) {
            parts->bar->tilesDone(done, total);
        };
    }
    renderOptions.stop = [this](int x, int y) {
        if (parts->bar) parts->bar->inPixel(x, y);
        return InterruptNotice::signal() != 0;
    };
    parts->whatIsLeft = "nothing was written";
    if (!extra.preview) return;
    requireFileForPreview(options.output);
    parts->whatIsLeft = options.output.string() + " has the last preview, if there was one";
    parts->preview.emplace(options.output, options.gamma, *options.crop, background);
    renderOptions.preview = [this](const sw::Window& tile, const sw::ColorAt& colors) {
        parts->preview->show(tile, colors);
    };
}

RenderWatch::~RenderWatch() = default;

bool RenderWatch::showsPasses() const {
    return parts->bar && stderrIsTerminal();
}

bool RenderWatch::passDone(const sw::AdaptiveProgress& progress) {
    parts->bar->passDone(progress.passes, progress.estimatedRmse);
    return true;
}

void RenderWatch::end(const sw::RenderResult& result) {
    const std::string left = parts->whatIsLeft;
    parts.reset();
    if (!result.complete)
        throw Interrupted(std::string("interrupted by ") + signalName() + "; " + left);
}

void tellOfLack(const Options& options, const sw::RenderResult& result) {
    if (result.roughPixels > 0 && !options.quiet)
        printWarnings(
            {"warning: there was no time for " + std::to_string(result.roughPixels) + " of " +
             std::to_string(static_cast<long long>(result.image.width()) * result.image.height()) +
             " pixels: they have the colour of a sample nearby, or of rays cut short"});
    const ExtraOptions& limits = options.extra;
    const bool onlyTarget =
        limits.targetRmse > 0 && !(limits.tolerance > 0) && limits.timeLimit == 0;
    if (onlyTarget && result.estimatedRmse > static_cast<double>(limits.targetRmse) &&
        InterruptNotice::signal() == 0 && !options.quiet)
        printWarnings(
            {"warning: the limit of samples per pixel ended the render above the target"});
    if (InterruptNotice::signal() != 0)
        throw Interrupted(std::string("interrupted by ") + signalName() + "; " +
                          options.output.string() + " has the picture so far");
}
