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

/// A line, thinner than a pixel, that may cross one unseen.
struct ThinFeature {
    float squaredError = 0;  ///< the error that it would cause
    float squaredShare = 0;  ///< of the pixel's area that it would cover
};

/// What adaptive sampling knows of one pixel.
struct AdaptivePixel {
    Color mean;          ///< of the samples
    float x = 0, y = 0;  ///< their mean position, from the pixel's top left corner
    int samples = 0;
    float variance = 0;        ///< of the mean, as far as these samples show it
    float contrast = 0;        ///< squared: the largest between places side by side in the pixel
    float unseenContrast = 0;  ///< squared: what the samples may have missed; see lookAround()
    ThinFeature thinFeature;   ///< what the samples may have missed as well
    /// Takes no more samples, as these take too long. If it has none, its mean is a colour nearby;
    /// if it has one, that sample's rays were cut short.
    bool isClosed = false;

    bool isRough() const { return isClosed && samples <= 1; }
};

/// A pixel and the eight around it, row by row. Outside the picture, the pixel itself takes their
/// place.
using Neighbourhood = std::array<const AdaptivePixel*, 9>;

/// How many samples a pixel has after its next refinement: 1, 4, 8, 16, ...
constexpr int refinedSamples(int samples) {
    return samples == 0 ? 1 : samples == 1 ? 4 : 2 * samples;
}

/// Takes the next samples of pixel (x, y).
void refine(AdaptivePixel& pixel, int x, int y, const RadianceAt& radiance, std::uint64_t seed);

/// Sets what the middle pixel may have missed, judging by its neighbours.
void lookAround(AdaptivePixel& pixel, const Neighbourhood& around);

/// Expected square of a pixel's error as displayed, in 0..1. It is 1 if a sample was NaN.
float squaredError(const AdaptivePixel& pixel);

/// How colour changes over a pixel, per pixel.
struct Slope {
    Color dx, dy;
};

/// As its neighbours suggest.
Slope slopeOf(const Neighbourhood& around);

/// The colour of the middle pixel.
Color resolve(const Neighbourhood& around);

}  // namespace sw
