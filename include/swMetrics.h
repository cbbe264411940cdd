#pragma once

#include "swImage.h"

namespace sw {

/// How far two pictures are apart. All but rmse8bit is in linear radiance. Channels are
/// clamped to 0..1 as in the picture; all three have the same weight.
struct Metrics {
    double rmse = 0;      ///< root of the mean squared difference, 0..1
    double psnr = 0;      ///< 20 log10(1 / rmse) in dB; infinite for equal pictures
    double largest = 0;   ///< largest difference in any channel of any pixel
    int x = 0, y = 0;     ///< the first pixel that has it
    double visible = 0;   ///< share of the pixels with a difference over 2/255 in any channel
    double rmse8bit = 0;  ///< RMSE in 8-bit code values, before rounding
};

/// @param b      as large as a
/// @param gamma  of the 8-bit picture
Metrics compare(const Image& a, const Image& b, float gamma = 2.2f);

/// Shows small numbers as colours, one colour per power of ten: black 0.0001 and less, blue 0.001,
/// red 0.01, yellow 0.1, white 1; numbers in between are interpolated. Grey is NaN.
/// @param errors  per channel, not negative; a pixel's colour shows their root mean square
Image heatMap(const Image& errors);

/// The absolute differences of two pictures' channels as displayed, for heatMap().
/// @param b  as large as a
Image absoluteDifference(const Image& a, const Image& b);

}  // namespace sw
