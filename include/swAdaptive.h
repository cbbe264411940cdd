#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "swImage.h"
#include "swRenderer.h"

/// Adaptive supersampling, after Whitted's own paper (An Improved Illumination Model for Shaded
/// Display, 1980, section "Visible surface processing and antialiasing"): where neighbouring
/// samples agree, one per pixel is enough; where they differ, subdivide.
///
/// Every pixel first gets one sample at a random place in it. Then, pass by pass, the pixels whose
/// estimated error is largest for what they have cost double their samples.
///
/// What can be lost:
/// - Whatever covers a whole pixel is seen by that pixel's first sample.
/// - Anything else is missed by all first samples with a probability of at most exp(-A), where A is
///   its area in pixels, whatever its shape: a line of width 0.1 and length 50 in 0.7 % of cases.
/// - What one pixel has seen makes its eight neighbours look closer, and their neighbours if these
///   find it too, one pixel further with each pass: edges and lines are followed. Next to a
///   contrast c of more than 7 tolerances, a pixel takes at least (c / (3.2 tolerance))^(2/3)
///   samples; n of them hit every horizontal or vertical line through it that is at least 2/n of a
///   pixel wide. Of thin white triangles on black, 25 pixels long and 0.2 wide at the foot, that
///   were seen at all, the picture shows 89 % of the area at tolerance 0.02, 96 % at 0.01.
namespace sw {

struct AdaptiveProgress {
    int passes = 0;             ///< done so far; the first takes one sample in every pixel
    std::uint64_t samples = 0;  ///< so far
    double estimatedRmse = 0;
    double seconds = 0;  ///< wall time so far
};

/// When to stop. Rendering ends at the first limit that is reached. A number that is not positive
/// is no limit; without any limit, every pixel of unknown error gets maxSamples.
struct AdaptiveOptions {
    /// A pixel whose mean has at most this estimated error needs no more samples. In linear
    /// radiance, as displayed: root mean square of the three channels, in 0..1.
    float tolerance = 0;
    float targetRmse = 0;   ///< estimated, of the whole window; in the same unit
    double timeLimit = 0;   ///< seconds of wall time; the first pass is always finished
    int maxSamples = 1024;  ///< per pixel: 1, 4, 8, 16, ..., at most 4096
    /// render.progress reports the first pass only, which is most of the work in smooth pictures.
    RenderOptions render = {};
    /// Called after every pass, by the calling thread: false ends the rendering.
    std::function<bool(const AdaptiveProgress&)> keepGoing = nullptr;
};

/// `samples` counts all samples, also those in the margin around the window. A pixel's estimated
/// error is the same in all channels.
struct AdaptiveResult : RenderResult {
    std::vector<int> sampleCounts;  ///< of each pixel, row by row
    int passes = 0;
};

/// Renders a window of a picture with as many samples in each pixel as its error asks for. The
/// result is the same for any number of threads and any tile size. If the tolerance alone ends the
/// rendering, any window gets the same pixels: what can influence the window is sampled as well, in
/// a margin of one pixel for each pass. A time limit makes the result depend on the machine; the
/// target RMSE is that of the window. Calls radiance concurrently: it must be thread-safe. If it
/// uses uniform(), the numbers depend on seed and pixel alone. The first exception that it throws
/// ends the rendering and is passed on.
/// @param window    part of the picture, at least one pixel
/// @param width     of the full picture
/// @param height    of the full picture
/// @param radiance  colour at a place: pixel (x, y) covers [x, x+1] x [y, y+1]
AdaptiveResult renderAdaptive(const Window& window, int width, int height,
                              const std::function<Color(float x, float y)>& radiance,
                              const AdaptiveOptions& options);

}  // namespace sw
