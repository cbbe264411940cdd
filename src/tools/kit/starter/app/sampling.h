#pragma once

#include <functional>
#include <optional>

#include "app/options.h"
#include "swRenderer.h"

// The lab has no way of taking samples other than samplePixel().

inline std::optional<sw::RenderResult> renderOtherwise(
    const Options&, const sw::RenderOptions&, const std::function<sw::Color(float x, float y)>&) {
    return std::nullopt;
}

inline void writeErrorImage(const SamplingOptions&, const sw::RenderResult&) {}
