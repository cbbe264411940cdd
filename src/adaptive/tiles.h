#pragma once

#include <algorithm>
#include <functional>

#include "swRenderer.h"

namespace sw {

inline Window common(const Window& a, const Window& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

inline Window grown(const Window& window, int by) {
    return {window.x0 - by, window.y0 - by, window.x1 + by, window.y1 + by};
}

inline Window within(const Window& window, int width, int height) {
    return {std::max(window.x0, 0), std::max(window.y0, 0), std::min(window.x1, width),
            std::min(window.y1, height)};
}

template <typename Function>
void forEachPixel(const Window& window, const Function& function) {
    for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) function(x, y);
}

/// What a sweep over tiles took.
struct Sweep {
    RayCount rays;
    int threads = 0;
};

/// Calls function(tile) for the tiles of a region. Uses the renderer's threads: each tile is a
/// pixel of a picture that is thrown away.
template <typename Function>
Sweep forEachTile(const Window& region, const RenderOptions& options, const Function& function,
                  const std::function<void(int, int)>& progress = nullptr) {
    const int side = std::max(1, options.tileSize);
    const Window tiles{0, 0, (region.width() + side - 1) / side,
                       (region.height() + side - 1) / side};
    const auto tile = [&](int column, int row) {
        const int x = region.x0 + column * side, y = region.y0 + row * side;
        function(common({x, y, x + side, y + side}, region));
        return Color();
    };
    RenderOptions how;
    how.tileSize = 1;
    how.threads = options.threads;
    how.progress = progress;
    const RenderResult result = render(tiles, tile, how);
    return {result.rays, result.threads};
}

}  // namespace sw
