#pragma once

#include <filesystem>

#include "swSampling.h"

namespace CLI {
class App;
}

/// Ways of taking samples other than samplePixel(): none in this lab.
struct SamplingOptions {
    sw::SamplePattern pattern = sw::SamplePattern::jitter;
    bool corners = false;
    std::filesystem::path errorImage;
};

inline void addSamplingOptions(CLI::App&, SamplingOptions&) {}
inline void checkSamplingOptions(const CLI::App&, const SamplingOptions&, int) {}
