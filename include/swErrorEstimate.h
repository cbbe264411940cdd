#pragma once

#include <vector>

#include "swImage.h"
#include "swSampling.h"

namespace sw {

/// The error of a channel as the picture shows it, cut off at 0 and 1: half the length of what
/// remains of mean +- error. 0 for a light that is brighter than white on all its samples; 1/2,
/// as anything is possible, for infinite samples.
float shownError(float mean, float error);

/// The standard error of a pixel's mean: how far, as root mean square, it is off the true mean.
///
/// One sample in each cell of an n x n grid does not show the variance within its cell. The
/// contrast q = a - b - c + d of four neighbouring cells does: q^2 / 4 has just that mean where
/// colour changes linearly (Matern, Spatial Variation, 1960; in one dimension Wolter, Introduction
/// to Variance Estimation, chapter 8). But pictures err at edges. An edge of random place and
/// direction separates two points with a chance proportional to their distance (Crofton's
/// formula), and q^2 is the sum of four squared differences of adjacent cells minus that of two
/// diagonal ones. So an edge makes q^2 / 4 larger than the variance by 2 D1 / D0 - D2 / D0 =
/// 1 / 0.742, the D being the mean distances of random points in the same, in adjacent and in
/// diagonal cells: 0.5214, 1.0881 and 1.4731. That factor makes the error of smooth surfaces, and
/// of edges along the axes, 14 % too small.
///
/// `multiJitter` has 0.6 of that variance at edges; measured on the shipped scenes. Of `grid`,
/// which has no variance, the estimate tells what jitter would give; `random` has the textbook's.
/// What no sample has hit remains unseen.
class PixelSamples {
public:
    /// Keeps the samples that its thread adds to a SampleMean, for as long as it lives.
    /// @param n  samples per side of the grid; less than 2: nothing is kept
    PixelSamples(SamplePattern pattern, int n);
    ~PixelSamples();
    PixelSamples(const PixelSamples&) = delete;
    PixelSamples& operator=(const PixelSamples&) = delete;

    /// Ends a pixel and starts the next.
    /// @param mean  the pixel's colour
    /// @return      its error as shown, per channel, in linear radiance. NaN where there were not
    ///              just n x n samples, or n is less than 2
    Color takeError(const Color& mean);

private:
    SamplePattern pattern;
    std::size_t n;
    float factor;  // from sums of squares to the variance of the mean
    std::vector<NotedSample> samples;
    SampleSpace outer;  // of a picture that is rendered by a pixel of another one
};

/// The picture's estimated RMSE in steps of its 8-bit encoding (compare Metrics::rmseSteps): what
/// the errors are worth from the mean downwards, where the encoding is steeper. Some 20 % too
/// small in the lab's picture: light that all samples of a black pixel miss is many steps.
/// @param errors  of its pixels, from RenderResult::errors; NaN anywhere makes the result NaN
double estimatedSteps(const Image& image, const Image& errors, float gamma = 2.2f);

}  // namespace sw
