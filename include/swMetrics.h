#pragma once

#include "swImage.h"

namespace sw {

/// A channel as an 8-bit code value before rounding, 0..256: toByte() truncates it.
double codeValue(float linear, float gamma = 2.2f);

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

/// A picture's estimated RMSE in 8-bit code values (compare Metrics::rmse8bit). Each error
/// counts from the mean downwards, where the code values are steeper. Some 20 % too small in the
/// lab's picture: if all samples of a black pixel miss a light part, that costs many code values.
/// @param errors  of its pixels, from RenderResult::errors; NaN anywhere makes the result NaN
double estimatedRmse8bit(const Image& image, const Image& errors, float gamma = 2.2f);

/// Shows small numbers as colours, one colour per power of ten: black 0.0001 and less, blue 0.001,
/// red 0.01, yellow 0.1, white 1; numbers in between are interpolated. Grey is NaN.
/// @param errors  per channel, not negative; a pixel's colour shows their root mean square
Image heatMap(const Image& errors);

/// The absolute differences of two pictures' channels as displayed, for heatMap().
/// @param b  as large as a
Image absoluteDifference(const Image& a, const Image& b);

}  // namespace sw
