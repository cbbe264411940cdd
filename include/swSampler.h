#pragma once

#include <array>
// kit >>>
#include <functional>
#include <vector>

#include "swVec3.h"
// <<<

namespace sw {

/// Where in its pixel the n x n samples lie.
enum class Sampler : unsigned char {
    jitter,      ///< one at a random place in each cell of an n x n grid, as in the lab
    grid,        ///< the centres of these cells; nothing random
    random,      ///< anywhere; for comparison
    multiJitter  ///< jitter with one sample in each of n^2 columns and n^2 rows, too
};

/// What users call the samplers, indexed by Sampler.
inline constexpr std::array<const char*, 4> samplerNames{"jitter", "grid", "random", "multijitter"};

// kit >>>
/// A place in a pixel: 0..1 from its top left corner.
struct SamplePoint {
    float x, y;
};

/// The places of a pixel's n x n samples, cell by cell and row by row (`random` knows no cells).
/// They come from uniform(), and so depend on the seed and the pixel alone.
/// Each sample is uniform in its cell. One sample, n = 1, is the pixel's centre, but for `random`.
/// @param n  at least 1
std::vector<SamplePoint> samplePoints(Sampler sampler, int n);

/// What the lab's samplePixel() does, with any sampler: the mean of n x n samples, each of which
/// is noted for the error estimate. With `jitter` the result is the same to the last bit.
/// @param x, y      the pixel's top left corner
/// @param radiance  the colour at a point of the picture
Color samplePixelWith(Sampler sampler, float x, float y, int n,
                      const std::function<Color(float x, float y)>& radiance);

// <<<
}  // namespace sw
