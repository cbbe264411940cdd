#pragma once

#include <filesystem>

#include "swSampling.h"

namespace CLI {
class App;
}

/// What the program can do beyond the lab: other ways of taking samples, and files beside the
/// picture.
struct ExtraOptions {
    sw::SamplePattern pattern = sw::SamplePattern::jitter;
    float tolerance = 0;          ///< adaptive: largest estimated error of a pixel; 0: none
    float targetRmse = 0;         ///< adaptive: largest estimated error of the picture; 0: none
    double timeLimit = 0;         ///< adaptive: of the whole run but writing, in seconds; 0: none
    bool preview = false;         ///< write the picture so far, every second
    bool corners = false;         ///< trace rays at the pixels' corners; samples is 1
    std::filesystem::path stats;  ///< JSON file for statistics; empty: none
    std::filesystem::path errorImage;  ///< PNG of the pixels' estimated errors; empty: none
    std::filesystem::path explore;     ///< page that shows the rays of every pixel; empty: none
    bool force = false;                ///< replace files of other kinds

    /// Whether the number of samples in each pixel depends on its error.
    bool isAdaptive() const { return tolerance > 0 || targetRmse > 0 || timeLimit > 0; }
};

/// Adds these options to the command line, and arranges the help.
/// @param app      holds all other options
/// @param options  must outlive the app: it takes their values
void addExtraOptions(CLI::App& app, ExtraOptions& options);

/// @param samples  per side of the lab's grid
/// @throws UsageError for options that exclude each other or do not exist
void checkExtraOptions(const CLI::App& app, const ExtraOptions& options, int samples);
