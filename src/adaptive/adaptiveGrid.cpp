#include "adaptive/adaptiveGrid.h"

#include <algorithm>

namespace sw {
namespace {

constexpr auto relaxed = std::memory_order_relaxed;

Window common(const Window& a, const Window& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

template <typename Function>
void forEachPixel(const Window& window, const Function& function) {
    for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) function(x, y);
}

}  // namespace

AdaptiveGrid::AdaptiveGrid(const Window& region, const RadianceAt& radiance,
                           const RenderOptions& options)
    : region(region),
      radiance(radiance),
      options(options),
      pixels(static_cast<std::size_t>(region.width()) * static_cast<std::size_t>(region.height())),
      errors(pixels.size()),
      stale(new std::atomic<bool>[pixels.size()]) {
    for (std::size_t i = 0; i < pixels.size(); ++i) stale[i].store(true, relaxed);
}

void AdaptiveGrid::start() {
    forEachTile(
        [this](const Window& tile) {
            forEachPixel(tile, [this](int x, int y) {
                refine(pixels[index(x, y)], x, y, radiance, options.seed);
            });
        },
        options.progress);
    taken = pixels.size();
    estimateErrors();
}

void AdaptiveGrid::refineWhere(const Window& window, const Need& needed,
                               const std::function<bool()>& late) {
    const std::uint64_t before = taken;
    forEachTile([&](const Window& tile) {
        if (late()) return;
        forEachPixel(common(tile, window), [&](int x, int y) {
            const std::size_t i = index(x, y);
            if (needed(errors[i], pixels[i].samples)) refinePixel(x, y, needed);
        });
    });
    if (taken != before) estimateErrors();
}

// Refines a pixel until it needs no more, as judged by what is known of its neighbours now.
void AdaptiveGrid::refinePixel(int x, int y, const Need& needed) {
    AdaptivePixel& pixel = pixels[index(x, y)];
    const int before = pixel.samples;
    while (needed(squaredError(pixel), pixel.samples)) refine(pixel, x, y, radiance, options.seed);
    taken.fetch_add(static_cast<std::uint64_t>(pixel.samples - before), relaxed);
    forEachPixel(common({x - 1, y - 1, x + 2, y + 2}, region),
                 [this](int i, int j) { stale[index(i, j)].store(true, relaxed); });
}

void AdaptiveGrid::estimateErrors() {
    forEachTile([this](const Window& tile) {
        forEachPixel(tile, [this](int x, int y) {
            const std::size_t i = index(x, y);
            if (!stale[i].load(relaxed)) return;
            stale[i].store(false, relaxed);
            lookAround(pixels[i], around(x, y));
            errors[i] = squaredError(pixels[i]);
        });
    });
}

Neighbourhood AdaptiveGrid::around(int x, int y) const {
    const AdaptivePixel* own = &pixels[index(x, y)];
    const auto pixelAt = [&](int i, int j) {
        const bool inside = i >= region.x0 && i < region.x1 && j >= region.y0 && j < region.y1;
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

// Uses the renderer's threads: each tile is a pixel of a picture that is thrown away.
template <typename TileFunction>
void AdaptiveGrid::forEachTile(const TileFunction& function,
                               const std::function<void(int, int)>& progress) {
    const int side = std::max(1, options.tileSize);
    const Window tiles{0, 0, (region.width() + side - 1) / side,
                       (region.height() + side - 1) / side};
    const auto tile = [&](int column, int row) {
        const int x = region.x0 + column * side, y = region.y0 + row * side;
        function(common({x, y, x + side, y + side}, region));
        return Color();
    };
    const RenderOptions tileOptions{
        .tileSize = 1, .threads = options.threads, .progress = progress};
    const RenderResult sweep = render(tiles, tile, tileOptions);
    traced += sweep.rays;
    mostThreads = std::max(mostThreads, sweep.threads);
}

}  // namespace sw
