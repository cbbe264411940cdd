#pragma once

#include <functional>
#include <vector>

#include "swSampling.h"

namespace sw {

/// A place in a pixel: 0..1 from its top left corner.
struct SamplePoint {
    float x, y;
};

/// The places of a pixel's n x n samples, cell by cell and row by row (`random` has no cells). They
/// come from uniform(), and so depend on the seed and the pixel alone. Each sample is uniform in
/// its cell. A single sample, n = 1, is the pixel's centre, except with `random`.
/// @param n  at least 1
std::vector<SamplePoint> samplePoints(SamplePattern pattern, int n);

/// What the lab's samplePixel() does, with any pattern: the mean of n x n samples. With `jitter`
/// the result is the same to the last bit.
/// @param x, y      the pixel's top left corner
/// @param radiance  the colour at a point of the picture
Color samplePixelWith(SamplePattern pattern, float x, float y, int n,
                      const std::function<Color(float x, float y)>& radiance);

}  // namespace sw
