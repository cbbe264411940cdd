#pragma once

#include <functional>
#include <vector>

#include "swSampling.h"

namespace sw {

/// A position in a pixel: 0..1 from its top left corner.
struct SamplePoint {
    float x, y;
};

/// The positions of a pixel's n x n samples, cell by cell and row by row (`random` has no cells).
/// They come from uniform(), so they depend on seed and pixel alone. Each sample is uniform in
/// its cell. A single sample, n = 1, is the pixel's centre, except with `random`.
/// @param n  at least 1
std::vector<SamplePoint> samplePoints(SamplePattern pattern, int n);

/// The lab's samplePixel() for any pattern: the mean of n x n samples. With `jitter` the result
/// equals samplePixel()'s to the last bit.
/// @param x, y      the pixel's top left corner
/// @param radiance  the colour at a point of the picture
Color samplePixelWith(SamplePattern pattern, float x, float y, int n,
                      const std::function<Color(float x, float y)>& radiance);

}  // namespace sw
