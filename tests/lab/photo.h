#pragma once

#include "swCamera.h"
#include "swImage.h"

namespace lab {

/// A picture of 96 x 96 pixels, one ray through the centre of each.
/// @param seen  the colour that a ray brings back
template <typename Seen>
sw::Image photo(sw::Camera camera, const Seen& seen) {
    constexpr int size = 96;
    camera.setup(size, size);
    sw::Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            image.at(x, y) =
                seen(camera.getRay(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
    return image;
}

}  // namespace lab
