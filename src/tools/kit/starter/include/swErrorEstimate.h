#pragma once

#include <vector>

#include "swImage.h"
#include "swSampling.h"

namespace sw {

/// Estimates the standard error of a pixel's mean: its RMS distance from the true mean.
///
/// One sample in each cell of an n x n grid does not show the variance within its cell. The
/// contrast q = a - b - c + d of four neighbouring cells does: q^2 / 4 has exactly that mean where
/// colour changes linearly (Matern, Spatial Variation, 1960), and is larger by 1 / 0.742 at edges,
/// where pictures err. The estimate knows nothing of objects that no sample has hit.
class PixelSamples {
public:
    /// During its lifetime, it records the samples that its thread adds to a SampleMean.
    /// @param n  samples per side of the grid; less than 2: nothing is kept
    PixelSamples(SamplePattern, int n);
    ~PixelSamples() { sampleSpace = {}; }
    PixelSamples(const PixelSamples&) = delete;
    PixelSamples& operator=(const PixelSamples&) = delete;

    /// Ends a pixel and starts the next.
    /// @param mean  the pixel's colour
    /// @return      its error as displayed, per channel, in linear radiance. NaN if there were not
    ///              exactly n x n samples, or n is less than 2
    Color takeError(const Color& mean);

private:
    std::size_t side;  // of the grid; 0: nothing is kept
    std::vector<NotedSample> samples;
};

}  // namespace sw
