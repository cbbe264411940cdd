#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "swVec3.h"

namespace sw {

using RadianceAt = std::function<Color(float x, float y)>;

/// Mean over the channels.
inline float square(const Color& color) {
    return color * color * (1.f / 3);
}

/// A line, thinner than a pixel, that may cross one.
struct Hair {
    float squaredError = 0;  ///< if it does, unseen
    float squaredShare = 0;  ///< of the pixel that it covers
};

/// What adaptive sampling knows of one pixel.
struct AdaptivePixel {
    Color mean;          ///< of the samples
    float x = 0, y = 0;  ///< where they lie on average, from the pixel's top left corner
    int samples = 0;
    float variance = 0;   ///< of the mean, as far as these samples show it
    float suspected = 0;  ///< squared contrast that may have been missed; see lookAround()
    Hair hair;            ///< that may have been missed
    float contrast = 0;   ///< squared: the largest between places side by side in the pixel
};

/// A pixel and the eight around it, row by row. Where the picture ends, the pixel itself stands in.
using Neighbourhood = std::array<const AdaptivePixel*, 9>;

/// How many samples a pixel has after its next refinement: 1, 4, 8, 16, ...
constexpr int refinedSamples(int samples) {
    return samples == 0 ? 1 : samples == 1 ? 4 : 2 * samples;
}

/// Takes the next samples of pixel (x, y).
void refine(AdaptivePixel& pixel, int x, int y, const RadianceAt& radiance, std::uint64_t seed);

/// Notes what the neighbours of the middle pixel let suspect in it.
void lookAround(AdaptivePixel& pixel, const Neighbourhood& around);

/// Expected square of the error that a pixel shows, in 0..1. 1 where a sample was not a number.
float squaredError(const AdaptivePixel& pixel);

/// The colour of the middle pixel.
Color resolve(const Neighbourhood& around);

}  // namespace sw
