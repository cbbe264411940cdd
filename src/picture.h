#pragma once

#include <functional>

#include "options.h"
#include "swImage.h"
#include "swRenderer.h"

/// What a run of the program makes.
struct Picture {
    sw::Image image;
    sw::Image errors;  ///< estimated, of every pixel; NaN where there is no estimate
    double samplesPerPixel = 0;
    sw::RenderStatistics statistics;
};

/// Renders in the way that the command line asks for.
/// @param options   with the size settled
/// @param radiance  colour at a point of the picture
/// @param labPixel  colour of a pixel from the lab's own supersampling
Picture renderPicture(const Options& options,
                      const std::function<sw::Color(float x, float y)>& radiance,
                      const std::function<sw::Color(int x, int y)>& labPixel);
