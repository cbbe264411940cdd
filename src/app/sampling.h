#pragma once

#include <functional>
#include <optional>

#include "app/options.h"
#include "swRenderer.h"

/// Renders in a way other than the lab's own samplePixel(); nothing, if the command line asks for
/// no other.
/// @param radiance  colour at a point of the picture
std::optional<sw::RenderResult> renderOtherwise(
    const Options& options, const sw::RenderOptions& how,
    const std::function<sw::Color(float x, float y)>& radiance);

/// Writes the error image, if the command line asks for it.
/// @throws sw::FileError
void writeErrorImage(const SamplingOptions& options, const sw::RenderResult& result);
