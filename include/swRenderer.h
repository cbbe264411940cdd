#pragma once

#include <cstdint>
#include <functional>

#include "swImage.h"
#include "swRayCount.h"
#include "swSampling.h"
#include "swStop.h"

namespace sw {

/// The pixels x0 <= x < x1, y0 <= y < y1 of a picture.
struct Window {
    int x0 = 0, y0 = 0;
    int x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

using ColorAt = std::function<Color(int x, int y)>;

struct RenderOptions {
    int tileSize = 16;       ///< pixels per side
    int threads = 0;         ///< 0: one per hardware thread
    std::uint64_t seed = 1;  ///< of uniform()'s random numbers
    /// Called after each tile with the number of tiles done, by one thread at a time.
    std::function<void(int done, int total)> progress = nullptr;
    SamplePattern pattern = SamplePattern::jitter;  ///< of radiance's samples ...
    int samples = 0;  ///< ... and their number per side of a pixel, for the error estimate
    StopQuestion stop = nullptr;  ///< asked often, in pixels as well: true ends the rendering
    /// Called after each tile with its pixels' colours so far, by one thread at a time.
    std::function<void(const Window& tile, const ColorAt& colors)> preview = nullptr;
};

/// A picture and what is known about it. Errors are root mean squares of the picture as displayed,
/// in linear radiance (see swErrorEstimate.h); NaN: there is no estimate.
struct RenderResult {
    Image image;
    Image errors;                           ///< estimated, of every pixel
    double estimatedRmse = 0;               ///< of the image
    double estimatedRmseStandardError = 0;  ///< of that estimate; 0: unknown
    std::uint64_t auditedPixels = 0;        ///< see renderAdaptive()
    std::uint64_t samples = 0;              ///< that were taken
    RayCount rays;
    int threads = 0;                ///< that took part
    double seconds = 0;             ///< wall time
    bool complete = true;           ///< false: options.stop has ended it, and pixels are missing
    std::uint64_t roughPixels = 0;  ///< that there was no time for; see renderAdaptive()
};

/// Renders a window of a picture.
/// Calls radiance concurrently: it must be thread-safe. It is called once for every pixel, each
/// with random numbers of its own, so the result is the same for any number of threads.
/// @param window    at least one pixel
/// @param radiance  colour of pixel (x, y), in coordinates of the full picture. The first exception
///                  it throws ends the rendering and is passed on. For an error estimate, it
///                  must add its options.samples^2 samples, at least four, to a SampleMean
RenderResult render(const Window& window, const std::function<Color(int x, int y)>& radiance,
                    const RenderOptions& options = {});

}  // namespace sw
