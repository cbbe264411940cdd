#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "adaptive/adaptivePixel.h"
#include "adaptive/coarsePicture.h"
#include "adaptive/timeShare.h"
#include "swRenderer.h"
#include "swZeroMemory.h"

namespace sw {

/// The pixels of a region with their samples and errors. All work is spread over tiles and threads.
/// Samples depend on errors and errors on samples, but never in the same sweep: the order in which
/// pixels are visited does not matter.
class AdaptiveGrid {
public:
    /// Which pixels to refine: those whose squared error is above both limits, unless they have too
    /// many samples.
    struct Need {
        float squaredError = 0;
        float squaredErrorPerSample = 0;
        int mostSamples = 0;

        bool operator()(float error, int samples) const {
            return error > squaredError &&
                   error > squaredErrorPerSample * static_cast<float>(samples) &&
                   refinedSamples(samples) <= mostSamples;
        }
    };

    AdaptiveGrid(const Window& region, const RadianceAt& radiance, const RenderOptions& options);

    /// Takes one sample in every pixel and estimates the errors. Pixels that time does not suffice
    /// for take their colours from the coarse picture.
    /// @param coarse  null: there is none
    /// @return  whether every pixel has a colour
    bool start(TimeShare& share, const CoarsePicture* coarse);

    /// Refines the pixels of a window that need it, while there is time, and updates the errors.
    void refineWhere(const Window& window, const Need& needed, TimeShare& share);

    const AdaptivePixel& pixel(int x, int y) const { return pixels[index(x, y)]; }
    float squaredErrorOf(int x, int y) const { return errors[index(x, y)]; }
    Color color(int x, int y) const { return resolve(around(x, y, region)); }

    /// How long it took to estimate all errors at the start.
    double secondsForErrors() const { return estimating; }
    std::uint64_t samples() const { return taken; }
    const RayCount& rays() const { return traced; }
    int threads() const { return mostThreads; }

private:
    template <typename Function>
    void sweep(const Function& function, const std::function<void(int, int)>& progress = nullptr);
    void show(const Window& tile, const Window& safe);
    void borrowColors(const CoarsePicture& coarse);
    void refinePixel(int x, int y, const Need& needed);
    void estimateErrors();
    Neighbourhood around(int x, int y, const Window& area) const;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - region.y0) * static_cast<std::size_t>(region.width()) +
               static_cast<std::size_t>(x - region.x0);
    }

    const Window region;
    const RadianceAt& radiance;
    const RenderOptions& options;
    std::vector<AdaptivePixel, ZeroMemory<AdaptivePixel>> pixels;
    std::vector<float, ZeroMemory<float>> errors;  // squared
    std::unique_ptr<std::atomic<bool>[]> stale;    // errors: the pixel or a neighbour has changed
    std::atomic<std::uint64_t> taken{0};
    std::mutex showing;
    RayCount traced;
    int mostThreads = 0;
    double estimating = 0;
};

}  // namespace sw
