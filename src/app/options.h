#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/extraOptions.h"
#include "app/usage.h"
#include "swRenderer.h"

/// A pixel of a picture; 0,0 is the top left one.
struct Pixel {
    int x = 0, y = 0;
};

/// The command line's options.
struct Options {
    std::filesystem::path scene;  ///< the lab's if none is given
    std::filesystem::path output = "out.png";
    int width = 0, height = 0;       ///< pixels; 0: the scene's own resolution
    int samples = 3;                 ///< per side of the grid in every pixel
    int depth = 3;                   ///< of the recursion; 0: primary rays only
    int threads = 0;                 ///< 0: one per hardware thread
    std::uint64_t seed = 1;          ///< of the random numbers
    std::optional<sw::Window> crop;  ///< render only this part of the picture
    std::optional<Pixel> pixel;      ///< print the rays behind it instead of rendering
    float gamma = 2.2f;              ///< of the PNG
    bool quiet = false;              ///< neither progress nor summary nor warnings
    ExtraOptions extra;
};

/// Reads the command line. --help and --version print on stdout and end the program.
/// @throws UsageError, sw::FileError
Options parseOptions(int argc, const char* const* argv);

/// Takes the scene's picture size unless the command line gives one.
/// @throws UsageError if the size is too large for memory, or the crop or pixel is outside the
/// picture
void settleSize(Options& options, int sceneWidth, int sceneHeight);
