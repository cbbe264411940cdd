#pragma once

#include <filesystem>

#include "swSampling.h"

namespace CLI {
class App;
}

/// Ways of taking samples other than the lab's own samplePixel().
struct SamplingOptions {
    sw::SamplePattern pattern = sw::SamplePattern::jitter;
    float tolerance = 0;               ///< adaptive: of each pixel's estimated error; 0: none
    float targetRmse = 0;              ///< adaptive: of the picture's estimated error; 0: none
    double timeLimit = 0;              ///< adaptive: in seconds; 0: none
    bool corners = false;              ///< shoot rays at the pixels' corners instead; samples is 1
    std::filesystem::path errorImage;  ///< PNG of the pixels' estimated errors; empty: none

    /// Whether as many samples are taken in each pixel as its error asks for.
    bool isAdaptive() const { return tolerance > 0 || targetRmse > 0 || timeLimit > 0; }
};

/// Adds these options to the command line.
/// @param options  must outlive the app: it takes their values
void addSamplingOptions(CLI::App& app, SamplingOptions& options);

/// @param samples  of the lab's own grid
/// @throws UsageError for options that exclude each other
void checkSamplingOptions(const CLI::App& app, const SamplingOptions& options, int samples);
