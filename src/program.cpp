#include "program.h"

#include <exception>
#include <iostream>
#include <new>

#include "lab.h"
#include "options.h"
#include "output.h"
#include "picture.h"
#include "pixel/pixelTree.h"
#include "swFile.h"
#include "swMetrics.h"
#include "swNff.h"
#include "swSampling.h"

using namespace sw;

namespace {

// Prints the rays behind one pixel.
void lookIntoPixel(Options options) {
    std::vector<NffShape> shapes;
    NffScene file = loadNff(options.scene, &shapes);
    settleSize(options, file.width, file.height);
    printWarnings(file.warnings);
    file.camera.setup(options.width, options.height);
    const auto trace = [&](const Ray& ray, const Scene& scene, int depth) {
        seedPixel(options.seed, options.pixel->x, options.pixel->y);
        return traceRay(ray, scene, depth);
    };
    std::cout << describePixel(options, file, std::move(shapes), trace) << std::flush;
}

// Loads, renders and writes what the command line asks for.
void run(Options options) {
    StepTimes seconds;
    StopWatch watch;

    NffScene file = loadNff(options.scene);
    settleSize(options, file.width, file.height);
    requireWritable(options.output);
    if (!options.stats.empty()) requireWritable(options.stats);
    if (!options.errorImage.empty()) requireWritable(options.errorImage);
    if (!options.quiet) printWarnings(file.warnings);
    seconds.load = watch.lap();

    file.camera.setup(options.width, options.height);
    file.scene.prepare();
    seconds.build = watch.lap();

    const auto radiance = [&](float x, float y) {
        return traceRay(file.camera.getRay(x, y), file.scene, options.depth);
    };
    const auto pixel = [&](int x, int y) {
        return samplePixel(static_cast<float>(x), static_cast<float>(y), options.samples,
                           options.depth, file.camera, file.scene);
    };
    const Picture picture = renderPicture(options, radiance, pixel);
    seconds.trace = watch.lap();

    writePng(picture.image, options.output, options.gamma);
    if (!options.errorImage.empty()) writePng(heatMap(picture.errors), options.errorImage);
    seconds.write = watch.lap();

    if (!options.stats.empty())
        writeFile(options.stats, statsJson(options, picture, seconds, file.scene));
    if (!options.quiet) std::cout << summary(options, picture, seconds) << std::endl;
}

}  // namespace

int runProgram(int argc, const char* const* argv) {
    const auto fail = [](int code, const std::exception& error) {
        std::cerr << "swtracer: " << error.what() << std::endl;
        return code;
    };
    try {
        const Options options = parseOptions(argc, argv);
        options.pixel ? lookIntoPixel(options) : run(options);
        return 0;
    } catch (const UsageError& error) {
        return fail(2, error);
    } catch (const NffError& error) {
        return fail(3, error);
    } catch (const FileError& error) {
        return fail(4, error);
    } catch (const std::bad_alloc&) {
        return fail(2, UsageError("too large for memory; try a smaller --size, or --crop"));
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}
