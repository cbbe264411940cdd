#pragma once

#include "swImage.h"

namespace sw {

/// What a picture shows of a channel's linear radiance: 0..1. NaN becomes 0.
inline float shown(float linear) {
    return linear > 0 ? (linear < 1 ? linear : 1) : 0;
}

/// A channel in steps of the 8-bit picture, 0..256: what toByte() cuts to a whole number.
double encoded(float linear, float gamma = 2.2f);

/// How far two pictures are apart. All but rmseSteps in linear radiance; channels are cut off at
/// 0 and 1 as in the picture, and count as equals.
struct Metrics {
    double rmse = 0;       ///< root of the mean squared difference, 0..1
    double psnr = 0;       ///< 20 log10(1 / rmse) in dB; infinite for equal pictures
    double largest = 0;    ///< difference in any channel of any pixel
    int x = 0, y = 0;      ///< the (first) pixel that has it
    double visible = 0;    ///< share of the pixels with a difference over 2/255 in any channel
    double rmseSteps = 0;  ///< RMSE in steps of the 8-bit picture, before they are rounded
};

/// @param b      as large as a
/// @param gamma  of the 8-bit picture
Metrics compare(const Image& a, const Image& b, float gamma = 2.2f);

/// Shows small numbers by colour, each of which stands for a power of ten: black 0.0001 and less,
/// blue 0.001, red 0.01, yellow 0.1, white 1; those between are mixed. Grey is NaN.
/// @param errors  per channel, not negative; a pixel's colour shows their root mean square
Image heatMap(const Image& errors);

/// The difference of two pictures' channels as shown, for heatMap().
/// @param b  as large as a
Image absoluteDifference(const Image& a, const Image& b);

}  // namespace sw
