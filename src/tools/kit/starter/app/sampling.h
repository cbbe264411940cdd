#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "swRenderer.h"

namespace CLI {
class App;
}
struct Options;

/// Ways of taking samples other than samplePixel(): none in this lab.
struct SamplingOptions {
    sw::SamplePattern pattern = sw::SamplePattern::jitter;
    bool corners = false;
    std::filesystem::path errorImage;
};

inline void addSamplingOptions(CLI::App&, SamplingOptions&) {}
inline void checkSamplingOptions(const CLI::App&, const Options&) {}

inline std::optional<sw::RenderResult> renderOtherwise(
    const Options&, const sw::RenderOptions&, const std::function<sw::Color(float x, float y)>&) {
    return std::nullopt;
}

inline void writeErrorImage(const SamplingOptions&, const sw::RenderResult&) {}
