#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "adaptive/adaptivePixel.h"
#include "adaptive/auditedPixel.h"
#include "adaptive/coarsePicture.h"
#include "adaptive/tiles.h"
#include "adaptive/timeShare.h"
#include "adaptive/unseenDetail.h"
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
        /// Whether some number of samples would need it.
        bool isPossible(float error) const {
            return error > squaredError && error > squaredErrorPerSample;
        }
    };

    AdaptiveGrid(const Window& region, const RadianceAt& radiance, const RenderOptions& options);

    /// Takes one sample in every pixel and estimates the errors. Pixels that time does not suffice
    /// for take their colours from the coarse picture.
    /// @param coarse  null: there is none
    /// @return  whether every pixel has a colour
    bool start(TimeShare& share, const CoarsePicture* coarse);

    /// Refines the pixels of a window that need it, while there is time, and updates the errors.
    /// @return  whether there were any
    bool refineWhere(const Window& window, const Need& needed, TimeShare& share);

    /// Calls function(x, y) for the pixels of a window, on all threads, while there is time.
    /// @param function  calls checkStop() first; what it returns are the samples that it took
    template <typename Function>
    void visitPixels(const Window& window, TimeShare& share, const Function& function) {
        const auto never = [](int, int) { return false; };
        sweep([&](const Window& tile) {
            const auto count = [&](int x, int y) {
                taken.fetch_add(static_cast<std::uint64_t>(function(x, y)));
            };
            visit(common(tile, window), share, count, never);
        });
    }
    /// Puts other pixels in the place of some, and updates their errors.
    /// @param spread  whether that changes their neighbours' errors, too
    void replace(const std::vector<AuditedPixel>& others, bool spread);
    /// What pixels may have missed, of which their own samples know nothing; at first, nothing.
    UnseenDetail unseen;
    /// By what the errors that samples know of are to be multiplied.
    float modelFactor = 1;

    const AdaptivePixel& pixel(int x, int y) const { return pixels[index(x, y)]; }
    /// As far as the samples know.
    float squaredErrorOf(int x, int y) const { return errors[index(x, y)]; }
    float unseenErrorOf(int x, int y) const {
        return unseen.squaredError(x, y, pixel(x, y), squaredErrorOf(x, y));
    }
    bool isFlat(int x, int y) const { return unseen.isFlat(pixel(x, y), squaredErrorOf(x, y)); }
    /// All in all.
    float wholeErrorOf(int x, int y) const {
        return std::min(modelFactor * squaredErrorOf(x, y) + unseenErrorOf(x, y), 1.f);
    }
    /// The same, but no factor makes it larger: it does not say which pixels err more.
    float ownErrorOf(int x, int y) const {
        const float factor = std::min(modelFactor, 1.f);
        return std::min(factor * squaredErrorOf(x, y) + unseenErrorOf(x, y), 1.f);
    }
    Color color(int x, int y) const { return resolve(around(x, y)); }
    Slope slope(int x, int y) const { return slopeOf(around(x, y)); }

    /// How long it took to estimate all errors at the start.
    double secondsForErrors() const { return estimating; }
    std::uint64_t samples() const { return taken; }
    const RayCount& rays() const { return traced; }
    int threads() const { return mostThreads; }

private:
    template <typename Function>
    void sweep(const Function& function, const std::function<void(int, int)>& progress = nullptr) {
        const Sweep done = forEachTile(region, options, function, progress);
        traced += done.rays;
        mostThreads = std::max(mostThreads, done.threads);
    }
    void show(const Window& tile, const Window& safe);
    void borrowColors(const CoarsePicture& coarse);
    void refinePixel(int x, int y, const Need& needed);
    void estimateErrors();
    Neighbourhood around(int x, int y, const Window& area) const;
    Neighbourhood around(int x, int y) const { return around(x, y, region); }
    void markStale(int x, int y);
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
