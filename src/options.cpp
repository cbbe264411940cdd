#include "options.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>

#include "scenePath.h"

namespace {

constexpr int largestSide = 16384;
constexpr long long mostPixels = 1LL << 28;  // 3 GiB of floats

// Reads a whole number at the start of text and removes it.
bool takeInt(std::string& text, int& value) {
    try {
        std::size_t length = 0;
        value = std::stoi(text, &length);
        text.erase(0, length);
        return true;
    } catch (const std::logic_error&) {
        return false;
    }
}

void readSize(std::string text, Options& options) {
    const std::string given = text;
    const bool read = takeInt(text, options.width) && text.substr(0, 1) == "x" &&
                      takeInt(text.erase(0, 1), options.height) && text.empty();
    const auto fits = [](int side) { return side >= 1 && side <= largestSide; };
    if (!read || !fits(options.width) || !fits(options.height))
        throw UsageError("--size: expected WIDTHxHEIGHT, each from 1 to 16384, found '" + given +
                         "'");
}

sw::Window toWindow(const std::vector<int>& crop) {
    const sw::Window window{crop[0], crop[1], crop[2], crop[3]};
    if (window.x0 < 0 || window.y0 < 0 || window.width() < 1 || window.height() < 1)
        throw UsageError("--crop: expected x0,y0,x1,y1 with 0 <= x0 < x1 and 0 <= y0 < y1");
    return window;
}

}  // namespace

Options parseOptions(int argc, const char* const* argv) {
    Options options;
    std::string size;
    std::vector<int> crop;

    CLI::App app("Renders a scene by Whitted ray tracing.", "swtracer");
    app.set_version_flag("--version", SW_VERSION);
    app.add_option("scene", options.scene, "scene file in NFF; default: the lab's scene");
    app.add_option("-o,--output", options.output, "picture to write, a PNG")->capture_default_str();
    app.add_option("--size", size, "WIDTHxHEIGHT in pixels; default: what the scene says");
    app.add_option("--samples", options.samples, "N for NxN samples per pixel; 1: its centre")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_option("--depth", options.depth, "how often a ray may be reflected or refracted")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app.add_option("--threads", options.threads, "0: all that the machine has")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "of the random numbers")->capture_default_str();
    app.add_option("--crop", crop, "x0,y0,x1,y1: only this window of the picture")
        ->delimiter(',')
        ->expected(4);
    app.add_option("--gamma", options.gamma, "of the picture")
        ->check(CLI::Range(0.1, 10.0))
        ->capture_default_str();
    app.add_flag("--quiet", options.quiet, "print nothing but errors");
    app.add_option("--stats", options.stats, "JSON file for ray counts and times");

    try {
        app.parse(argc, argv);
        if (app.count("--size") > 0) readSize(size, options);
        if (!crop.empty()) options.crop = toWindow(crop);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) std::exit(app.exit(error));  // --help, --version
        throw UsageError(error.what());
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
    if (static_cast<long long>(crop.width()) * crop.height() > mostPixels)
        throw UsageError("a picture of " + size +
                         " is too large for memory; expected at most 2^28 pixels (use --crop)");
}
