#include "app/options.h"

#include <charconv>
#include <cstdlib>
#include <span>
#include <sstream>

#include "app/console.h"
#include "app/scenePath.h"
#include "app/validators.h"

namespace {

constexpr int largestSide = 16384;
constexpr long long mostPixels = 1LL << 28;  // 3 GiB of floats

// Reads integers with separators between them, "512x512" for example. Returns false if the text is
// anything else.
bool readInts(const std::string& text, char separator, std::span<int> values) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator)) return false;
        const auto result = std::from_chars(at, end, values[i]);
        if (result.ec != std::errc()) return false;
        at = result.ptr;
    }
    return at == end;
}

void readSize(const std::string& text, Options& options) {
    int size[2];
    const auto fits = [](int side) { return side >= 1 && side <= largestSide; };
    if (!readInts(text, 'x', size) || !fits(size[0]) || !fits(size[1]))
        throw UsageError("--size: expected WIDTHxHEIGHT, each from 1 to 16384, found '" + text +
                         "'");
    options.width = size[0];
    options.height = size[1];
}

sw::Window readCrop(const std::string& text) {
    int c[4];
    if (!readInts(text, ',', c) || c[0] < 0 || c[1] < 0 || c[0] >= c[2] || c[1] >= c[3])
        throw UsageError("--crop: expected x0,y0,x1,y1 with 0 <= x0 < x1, 0 <= y0 < y1, found '" +
                         text + "'");
    return {c[0], c[1], c[2], c[3]};
}

Pixel readPixel(const std::string& text) {
    int p[2];
    if (!readInts(text, ',', p) || p[0] < 0 || p[1] < 0)
        throw UsageError("--pixel: expected x,y, each 0 or more, found '" + text + "'");
    return {p[0], p[1]};
}

// Refuses options of different ways to sample a picture, and options of pictures beside --pixel.
void requireOneWay(const CLI::App& app, const Options& options) {
    if (options.pixel)
        refuseBeside(app, "--pixel",
                     {"--output", "--samples", "--sampler", "--adaptive", "--target-rmse",
                      "--time-limit", "--corners", "--threads", "--crop", "--quiet", "--stats",
                      "--error-image", "--preview", "--explore"});
    checkExtraOptions(app, options.extra, options.samples);
}

}  // namespace

Options parseOptions(int argc, const char* const* argv) {
    Options options;
    std::string size, crop, pixel;

    CLI::App app("Renders a scene by Whitted ray tracing.", "swtracer");
    app.allow_windows_style_options(false);  // there, too, /data/my.nff is a scene
    app.set_version_flag("--version", SW_VERSION);
    app.add_option("scene", options.scene, "scene file in NFF; default: the lab's scene");
    app.add_option("-o,--output", options.output, "picture to write")->capture_default_str();
    app.add_option("--size", size, "WIDTHxHEIGHT in pixels; default: the scene's resolution");
    addNumber(app, "--samples", options.samples, 1, 256,
              "N: NxN samples per pixel; 1: the pixel's centre");
    addNumber(app, "--depth", options.depth, 0, 1000,
              "maximum number of successive reflections and refractions");
    addNumber(app, "--threads", options.threads, 0, 1024,
              "number of threads; 0: one per hardware thread");
    addNumber<std::uint64_t>(app, "--seed", options.seed, 0, UINT64_MAX, "of the random numbers");
    app.add_option("--crop", crop, "x0,y0,x1,y1: render only this window of the picture");
    app.add_option("--pixel", pixel,
                   "x,y: print the tree of rays behind this pixel's centre instead of rendering");
    addNumber(app, "--gamma", options.gamma, 0.1f, 10.0f, "gamma of the PNG");
    app.add_flag("--quiet", options.quiet, "print only errors: no warnings either");
    addExtraOptions(app, options.extra);

    try {
        app.parse(argc, argv);
        if (app.count("--size") > 0) readSize(size, options);
        if (app.count("--crop") > 0) options.crop = readCrop(crop);
        if (app.count("--pixel") > 0) options.pixel = readPixel(pixel);
        if (app.count("scene") > 0 && options.scene.empty())
            throw UsageError("scene: expected the name of a file, found '' (a variable not set?)");
        requireOneWay(app, options);
        if (options.extra.corners) options.samples = 1;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw UsageError(inPlainWords(error));
        std::ostringstream text;  // --help, --version
        app.exit(error, text);
        print(text.str());
        std::exit(0);
    }
    if (options.scene.empty()) options.scene = findShippedScene("cornell.nff", argv[0]);
    return options;
}

void settleSize(Options& options, int sceneWidth, int sceneHeight) {
    if (options.width == 0) {
        options.width = sceneWidth;
        options.height = sceneHeight;
    }
    const std::string size = std::to_string(options.width) + "x" + std::to_string(options.height);
    if (!options.crop) options.crop = sw::Window{0, 0, options.width, options.height};
    const sw::Window& crop = *options.crop;
    if (crop.x1 > options.width || crop.y1 > options.height)
        throw UsageError("--crop: expected a window within " + size + ", found one that ends at " +
                         std::to_string(crop.x1) + "," + std::to_string(crop.y1));
    if (options.pixel && (options.pixel->x >= options.width || options.pixel->y >= options.height))
        throw UsageError("--pixel: expected a pixel within " + size + ", found " +
                         std::to_string(options.pixel->x) + "," + std::to_string(options.pixel->y));
    if (static_cast<long long>(crop.width()) * crop.height() > mostPixels)
        throw UsageError("a picture of " + size +
                         " is too large for memory; expected at most 2^28 pixels (use --crop)");
}
