#pragma once

#include <vector>

#include "swImage.h"
#include "swSampling.h"

namespace sw {

/// The error of a channel as displayed: half the length of the interval mean +- error after
/// clamping to 0..1. It is 0 if all samples are far brighter than white, and 1/2 if samples are
/// infinite, because then nothing is known.
float displayedError(float mean, float error);

/// Estimates the standard error of a pixel's mean: its RMS distance from the true mean.
///
/// One sample in each cell of an n x n grid does not show the variance within its cell. The
/// contrast q = a - b - c + d of four neighbouring cells does: q^2 / 4 has exactly that mean where
/// colour changes linearly (Matern, Spatial Variation, 1960; in one dimension Wolter, Introduction
/// to Variance Estimation, chapter 8). But pictures err at edges. An edge of random place and
/// direction separates two points with a chance proportional to their distance (Crofton's
/// formula), and q^2 is the sum of four squared differences of adjacent cells minus that of two
/// diagonal ones. So an edge makes q^2 / 4 larger than the variance by 2 D1 / D0 - D2 / D0 =
/// 1 / 0.742, the D being the mean distances of random points in the same, in adjacent and in
/// diagonal cells: 0.5214, 1.0881 and 1.4731. That factor makes the error of smooth surfaces, and
/// of edges along the axes, 14 % too small.
///
/// `multiJitter` has 0.6 of that variance at edges, measured on the shipped scenes. `grid` has no
/// variance: it gets the estimate for jitter. `random` gets the textbook estimate. The
/// estimate knows nothing of objects that no sample has hit.
class PixelSamples {
public:
    /// During its lifetime, it records the samples that its thread adds to a SampleMean.
    /// @param n  samples per side of the grid; less than 2: nothing is kept
    PixelSamples(SamplePattern pattern, int n);
    ~PixelSamples();
    PixelSamples(const PixelSamples&) = delete;
    PixelSamples& operator=(const PixelSamples&) = delete;

    /// Ends a pixel and starts the next.
    /// @param mean  the pixel's colour
    /// @return      its error as displayed, per channel, in linear radiance. NaN if there were not
    ///              exactly n x n samples, or n is less than 2
    Color takeError(const Color& mean);

private:
    SamplePattern pattern;
    std::size_t side;  // of the grid; 0: nothing is kept
    float factor;      // turns sums of squares into the variance of the mean
    std::vector<NotedSample> samples;
    SampleSpace outer;  // the one before: a pixel may render a picture of its own
};

}  // namespace sw
