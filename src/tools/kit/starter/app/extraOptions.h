#pragma once

#include <filesystem>

#include "swSampling.h"

namespace CLI {
class App;
}

/// What the program can do beyond the lab: nothing here.
struct ExtraOptions {
    sw::SamplePattern pattern = sw::SamplePattern::jitter;
    bool corners = false;
    std::filesystem::path stats, errorImage, explore;
};

inline void addExtraOptions(CLI::App&, ExtraOptions&) {}
inline void checkExtraOptions(const CLI::App&, const ExtraOptions&, int) {}
