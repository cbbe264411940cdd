#pragma once

#include <stdexcept>

#include "app/options.h"
#include "swRenderer.h"

// Nothing goes on beside a render.

struct Interrupted : std::runtime_error {
    static int exitCode() { return 1; }
};

struct RenderWatch {
    RenderWatch(const Options& all, const sw::Color&)
        : options{.threads = all.threads, .seed = all.seed, .samples = all.samples} {}
    const sw::RenderOptions& how() const { return options; }
    void end(const sw::RenderResult&) const {}

    const sw::RenderOptions options;
};

inline void tellOfLack(const Options&, const sw::RenderResult&) {}
