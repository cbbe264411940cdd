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
/// First, every pixel gets one sample at a random place in it. Then each pass doubles the samples
/// of the pixels with the largest estimated error for their cost.
///
/// What may be missed:
/// - An object that covers a whole pixel is never missed: that pixel's first sample hits it.
/// - Any other object is missed by all first samples with a probability of at most exp(-A), where A
///   is its area in pixels. Its shape does not matter: a line of width 0.1 and length 50 is missed
///   in 0.7 % of cases.
/// - If a pixel sees a contrast, its eight neighbours are sampled more. If they see it too, so are
///   their neighbours, one pixel further per pass: edges and lines are followed. Next to a
///   contrast c of more than 7 tolerances, a pixel takes at least (c / (3.2 tolerance))^(2/3)
///   samples; n of them hit every horizontal or vertical line through it that is at least 2/n of a
///   pixel wide. For thin white triangles on black, 25 pixels long and 0.2 wide at the
///   foot, the picture shows 89 % of the area at tolerance 0.02 and 96 % at 0.01, if any sample
///   hit them.
///
/// What is missed is counted nevertheless. In the end, an audit takes samples that are independent
/// of all before: one in an eighth of the pixels that seem flat (more in small pictures), many
/// where that one differs, and again in some of the others. estimatedRmse is what the audit has
/// measured. Details that it finds are repaired, and where they are more than a tolerance or a
/// target allows, all flat pixels around are sampled again. Audit samples that agree with their
/// pixel do not enter its mean: they would not change it. Those that judge a busy pixel do not,
/// either: which pixels are judged depends on the window, and the picture must not.
namespace sw {

struct AdaptiveProgress {
    int passes = 0;             ///< done so far; the first takes one sample in every pixel
    std::uint64_t samples = 0;  ///< so far
    double estimatedRmse = 0;
    double seconds = 0;  ///< wall time so far
};

/// When to stop. Rendering ends at the first limit that is reached. A number that is not positive
/// means no limit. Without any limit, every pixel of unknown error gets maxSamples.
struct AdaptiveOptions {
    /// A pixel whose mean has at most this estimated error needs no more samples. In linear
    /// radiance, as displayed: root mean square of the three channels, in 0..1.
    float tolerance = 0;
    float targetRmse = 0;   ///< as audited, of the whole window; in the same unit
    double timeLimit = 0;   ///< seconds of wall time; see renderAdaptive()
    int maxSamples = 1024;  ///< per pixel: 1, 4, 8, 16, ..., at most 4096
    /// Whether the result has `errors` and `sampleCounts`. They take 16 of its 28 bytes per pixel,
    /// and where time is short for a huge picture, it goes into memory.
    bool details = true;
    /// render.progress reports every pass, from its first tile to its last. render.stop ends the
    /// rendering as a time limit does.
    RenderOptions render = {};
    /// Called after every pass, by the calling thread: false ends the rendering.
    std::function<bool(const AdaptiveProgress&)> keepGoing = nullptr;
};

/// `samples` counts all samples, also those in the margin around the window and those of the audit.
/// A pixel's estimated error is the same in all channels. estimatedRmseStandardError is 0, unknown,
/// if the rendering was ended by render.stop or keepGoing, or if there was no time for an audit.
struct AdaptiveResult : RenderResult {
    std::vector<int> sampleCounts;  ///< of each pixel, row by row; 0: a rough one
    int passes = 0;                 ///< 0: there was no time for one sample in every pixel
};

/// Renders a window of a picture and chooses the number of samples in each pixel by its error. The
/// result is the same for any number of threads and any tile size. If the tolerance alone ends the
/// rendering, a pixel is the same in every window: a margin of one pixel per pass is sampled as
/// well, as it can influence the window. A time limit makes the result depend on the machine; the
/// target RMSE is that of the window. Calls radiance concurrently: it must be thread-safe. If it
/// uses uniform(), the numbers depend on seed and pixel alone. The first exception that it throws
/// ends the rendering and is passed on.
///
/// With a time limit, a coarse picture comes first, and stands in for the pixels that there is no
/// time for. Some 64 pixels are sampled in any case. Where a pixel takes very long, its rays are
/// cut short after ShortRays::generations, so far as they come from Intersection::spawnRay(). All
/// these are the result's roughPixels. If render.stop ends the first pass and there is no time
/// limit, the result is not `complete`; later, it is.
/// @param window    part of the picture, at least one pixel
/// @param width     of the full picture
/// @param height    of the full picture
/// @param radiance  colour at a place: pixel (x, y) covers [x, x+1] x [y, y+1]
AdaptiveResult renderAdaptive(const Window& window, int width, int height,
                              const std::function<Color(float x, float y)>& radiance,
                              const AdaptiveOptions& options);

}  // namespace sw
