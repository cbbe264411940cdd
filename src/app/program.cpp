#include "app/program.h"

#include <exception>
#include <new>

#include "app/console.h"
#include "app/extras.h"
#include "app/outputs.h"
#include "app/pixelFaults.h"
#include "app/pixelTree.h"
#include "app/renderWatch.h"
#include "app/stackGuard.h"
#include "swFile.h"
#include "swSampling.h"

using namespace sw;

const NffScene& Run::loadScene() {
    const bool needsShapes = options.pixel || !options.extra.explore.empty();
    file = loadNff(options.scene, needsShapes ? &shapes : nullptr);
    settleSize(options, file->width, file->height);
    if (!options.pixel) requireOutputs(options);
    if (!options.quiet) printWarnings(file->warnings);
    seconds.load = watch.lap();

    file->camera.setup(options.width, options.height);
    file->scene.prepare();
    seconds.build = watch.lap();
    return *file;
}

void Run::render(const rayTree::Trace& traceRay,
                 const std::function<Color(int x, int y)>& samplePixel) {
    if (options.pixel) {
        const auto repeatable = [&](const Ray& ray, const Scene& scene, int rayDepth) {
            seedPixel(options.seed, options.pixel->x, options.pixel->y);
            return traceRay(ray, scene, rayDepth);
        };
        pixelText = describePixel(options, *file, std::move(shapes), repeatable);
        return;
    }
    recording = recordExtras(options, *file, std::move(shapes), traceRay);
    seconds.record = watch.lap();
    const auto radiance = [&](float x, float y) {
        stackGuard::watch(static_cast<int>(x), static_cast<int>(y));
        return traceRay(file->camera.getRay(x, y), file->scene, options.depth);
    };
    const auto pixel = [&](int x, int y) {
        stackGuard::watch(x, y);
        return samplePixel(x, y);
    };
    RenderWatch attended(options, file->scene.background());
    result = renderOtherwise(options, seconds, attended, radiance);
    if (!result) result = sw::render(*options.crop, pixel, attended.how());
    attended.end(*result);
    seconds.trace = watch.lap();
}

void Run::write() {
    if (options.pixel) return print(pixelText);
    const std::string failure = savePicture(result->image, options);
    seconds.write = watch.lap();
    writeExtras(options, *result, seconds, *file, recording.get(), failure);
    if (!options.quiet)
        printWarnings(describeFaults(result->image, options.crop->x0, options.crop->y0));
    if (!options.quiet) printSummary(summary(options, *result, seconds), options);
    tellOfLack(options, *result);
}

int runProgram(int argc, const char* const* argv, const std::function<void(Run&)>& steps) {
    const auto fail = [](int code, const std::exception& error) {
        printWarnings({error.what()});
        return code;
    };
    try {
        Run run(checkFiles(parseOptions(argc, argv)));
        steps(run);
        return 0;
    } catch (const UsageError& error) {
        return fail(2, error);
    } catch (const NffError& error) {
        return fail(3, error);
    } catch (const FileError& error) {
        return fail(4, error);
    } catch (const Interrupted& error) {
        return fail(Interrupted::exitCode(), error);
    } catch (const std::bad_alloc&) {
        return fail(2, UsageError("too large for memory; try a smaller --size, or --crop"));
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}
