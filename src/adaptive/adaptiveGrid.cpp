#include "adaptive/adaptiveGrid.h"

#include <algorithm>

#include "adaptive/tiles.h"

namespace sw {
namespace {

constexpr auto relaxed = std::memory_order_relaxed;

}  // namespace

AdaptiveGrid::AdaptiveGrid(const Window& region, const RadianceAt& radiance,
                           const RenderOptions& options)
    : unseen(region),
      region(region),
      radiance(radiance),
      options(options),
      pixels(static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height())),
      errors(pixels.size()),
      stale(new std::atomic<bool>[pixels.size()]) {
    for (std::size_t i = 0; i < pixels.size(); ++i) stale[i].store(true, relaxed);
}

bool AdaptiveGrid::start(TimeShare& share, const CoarsePicture* coarse) {
    const auto firstSamples = [&](const Window& tile) {
        std::uint64_t count = 0;
        const auto first = [&](int x, int y) {
            checkStop(x, y, 1);
            AdaptivePixel& own = pixels[index(x, y)];
            refine(own, x, y, radiance, options.seed);
            own.isClosed = ShortRays::areOn();
            ++count;
        };
        const auto takesLong = [&](int x, int y) { return coarse && coarse->takesLong(x, y); };
        visit(tile, share, first, takesLong);
        taken.fetch_add(count, relaxed);
        show(tile, tile);
    };
    sweep(firstSamples, options.progress);
    if (taken != pixels.size()) {
        if (!coarse) return false;
        borrowColors(*coarse);
    }
    const auto start = Clock::now();
    estimateErrors();
    estimating = std::chrono::duration<double>(Clock::now() - start).count();
    return true;
}

void AdaptiveGrid::borrowColors(const CoarsePicture& coarse) {
    sweep([&](const Window& tile) {
        forEachPixel(tile, [&](int x, int y) {
            AdaptivePixel& pixel = pixels[index(x, y)];
            if (pixel.samples > 0) return;
            pixel.mean = coarse.at(x, y).color;
            pixel.variance = coarse.squaredErrorAt(x, y);
            pixel.x = pixel.y = 0.5f;
            pixel.isClosed = true;
        });
    });
}

bool AdaptiveGrid::refineWhere(const Window& window, const Need& needed, TimeShare& share) {
    const std::uint64_t before = taken;
    const auto never = [](int, int) { return false; };
    const auto refineTile = [&](const Window& tile) {
        bool changed = false;
        const auto refineIfNeeded = [&](int x, int y) {
            const float error = errors[index(x, y)] + unseenErrorOf(x, y);
            if (!needed.isPossible(error)) return;  // most pixels: not even looked at
            AdaptivePixel& own = pixels[index(x, y)];
            if (ShortRays::areOn()) own.isClosed = true;
            if (own.isClosed || !needed(error, own.samples)) return;
            changed = true;
            checkStop(x, y, own.samples);
            refinePixel(x, y, needed);
        };
        visit(common(tile, window), share, refineIfNeeded, never);
        if (changed) show(tile, tile);
    };
    sweep(refineTile, options.progress);
    if (taken == before) return false;
    estimateErrors();
    return true;
}

// Refines a pixel until it needs no more, as judged by what is known of its neighbours now.
void AdaptiveGrid::refinePixel(int x, int y, const Need& needed) {
    AdaptivePixel& pixel = pixels[index(x, y)];
    markStale(x, y);
    while (needed(squaredError(pixel) + unseenErrorOf(x, y), pixel.samples)) {
        const int before = pixel.samples;
        refine(pixel, x, y, radiance, options.seed);
        taken.fetch_add(static_cast<std::uint64_t>(pixel.samples - before), relaxed);
    }
}

// The pixel has changed: its error and its neighbours' are to be estimated again.
void AdaptiveGrid::markStale(int x, int y) {
    forEachPixel(common({x - 1, y - 1, x + 2, y + 2}, region),
                 [this](int i, int j) { stale[index(i, j)].store(true, relaxed); });
}

void AdaptiveGrid::replace(const std::vector<AuditedPixel>& others, bool spread) {
    for (const AuditedPixel& other : others) {
        const std::size_t i = index(other.x, other.y);
        pixels[i] = other.judge;
        errors[i] = squaredError(other.judge);
        if (spread) markStale(other.x, other.y);
    }
    if (spread) estimateErrors();
}

void AdaptiveGrid::estimateErrors() {
    sweep([this](const Window& tile) {
        bool changed = false;
        forEachPixel(tile, [&](int x, int y) {
            const std::size_t i = index(x, y);
            if (!stale[i].load(relaxed)) return;
            stale[i].store(false, relaxed);
            lookAround(pixels[i], around(x, y, region));
            errors[i] = squaredError(pixels[i]);
            changed = true;
        });
        if (changed) show(tile, region);
    });
}

// Hands the pixels of a tile to who wants to see them before the end.
// @param safe  where no other thread changes pixels
void AdaptiveGrid::show(const Window& tile, const Window& safe) {
    if (!options.preview) return;
    const std::lock_guard lock(showing);
    options.preview(tile, [&](int x, int y) { return resolve(around(x, y, safe)); });
}

Neighbourhood AdaptiveGrid::around(int x, int y, const Window& area) const {
    const AdaptivePixel* own = &pixels[index(x, y)];
    const auto pixelAt = [&](int i, int j) {
        const bool inside = i >= area.x0 && i < area.x1 && j >= area.y0 && j < area.y1;
        return inside ? &pixels[index(i, j)] : own;
    };
    return {pixelAt(x - 1, y - 1),
            pixelAt(x, y - 1),
            pixelAt(x + 1, y - 1),
            pixelAt(x - 1, y),
            own,
            pixelAt(x + 1, y),
            pixelAt(x - 1, y + 1),
            pixelAt(x, y + 1),
            pixelAt(x + 1, y + 1)};
}

}  // namespace sw
