#pragma once

#include <functional>

#include "app/options.h"
#include "swRenderer.h"

/// Renders in the way that the command line asks for.
/// @param options      with the size settled
/// @param radiance     colour at a point of the picture
/// @param samplePixel  colour of a pixel from the lab's own supersampling
sw::RenderResult renderPicture(const Options& options,
                               const std::function<sw::Color(float x, float y)>& radiance,
                               const std::function<sw::Color(int x, int y)>& samplePixel);
