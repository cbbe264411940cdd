#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "swImage.h"
#include "swRayCount.h"
#include "swSampler.h"

namespace sw {

/// The pixels x0 <= x < x1, y0 <= y < y1 of a picture.
struct Window {
    int x0 = 0, y0 = 0;
    int x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

struct RenderOptions {
    int tileSize = 16;       ///< pixels per side
    int threads = 0;         ///< 0: one per hardware thread
    std::uint64_t seed = 1;  ///< of the random numbers that uniform() hands out
    /// Told after each tile how many are done. Called by one thread at a time.
    std::function<void(int done, int total)> progress = nullptr;
    Sampler sampler = Sampler::jitter;  ///< how radiance takes its samples ...
    int samples = 0;                    ///< ... and how many per side, for the error estimate
    Image* errors = nullptr;            ///< takes each pixel's estimated error: as large as the
                                        ///< image, linear radiance as shown, NaN: no estimate
};

struct RenderStatistics {
    RayCount rays;
    int threads = 0;     ///< that took part
    double seconds = 0;  ///< wall time
    /// Of the picture as shown, in linear radiance (see swErrorEstimate.h). NaN unless
    /// radiance notes all samples, and at least 2 x 2 of them.
    double estimatedRmse = std::numeric_limits<double>::quiet_NaN();
};

/// Fills a window of a picture.
/// Calls radiance concurrently: it must be thread-safe. Every pixel is written once, with its own
/// random numbers, so the result is the same for any number of threads.
/// @param window    must be as large as the image
/// @param radiance  colour of pixel (x, y), in coordinates of the full picture. The first exception
///                  it throws ends the rendering and is passed on
RenderStatistics render(Image& image, const Window& window,
                        const std::function<Color(int x, int y)>& radiance,
                        const RenderOptions& options = {});

/// Like render(), but takes the colours at the corners of pixels: each pixel becomes the mean of
/// its four corners, each of which is asked for once. A window of w x h pixels has (w + 1) x (h +
/// 1). There is no error estimate: all of options.errors becomes NaN.
/// @param radiance  colour at (x, y), the top left corner of pixel (x, y)
RenderStatistics renderCorners(Image& image, const Window& window,
                               const std::function<Color(int x, int y)>& radiance,
                               const RenderOptions& options = {});

}  // namespace sw
