#pragma once

#include "swRenderer.h"

namespace sw {

/// Like render(), but samples the corners of pixels, each corner once. A pixel becomes the mean of
/// its four corners. A window of w x h pixels has (w + 1) x (h + 1) corners, and counts as one
/// sample per pixel. There is no error estimate.
/// @param radiance  colour at (x, y), the top left corner of pixel (x, y)
RenderResult renderCorners(const Window& window, const std::function<Color(int x, int y)>& radiance,
                           const RenderOptions& options = {});

}  // namespace sw
