#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "swRenderer.h"

namespace CLI {
class App;
}
struct Options;

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

/// @throws UsageError for options that exclude each other
void checkSamplingOptions(const CLI::App& app, const Options& options);

/// Renders in one of these ways; nothing, if the command line asks for none of them.
/// @param radiance  colour at a point of the picture
std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const sw::RenderOptions& how,
    const std::function<sw::Color(float x, float y)>& radiance);

/// Writes the error image, if the command line asks for it.
/// @throws sw::FileError
void writeErrorImage(const SamplingOptions& options, const sw::RenderResult& result);
