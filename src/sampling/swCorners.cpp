#include "swCorners.h"

#include <cmath>
#include <utility>

namespace sw {

RenderResult renderCorners(const Window& window, const std::function<Color(int x, int y)>& radiance,
                           const RenderOptions& options) {
    const Window with{window.x0, window.y0, window.x1 + 1, window.y1 + 1};
    RenderResult result = render(with, radiance, options);
    const Image corners = std::exchange(result.image, Image(window.width(), window.height()));
    result.errors = Image(window.width(), window.height());
    result.samples =
        static_cast<std::uint64_t>(window.width()) * static_cast<std::uint64_t>(window.height());
    for (int y = 0; y < window.height(); ++y) {
        for (int x = 0; x < window.width(); ++x) {
            result.image.at(x, y) = 0.25f * (corners.at(x, y) + corners.at(x + 1, y) +
                                             corners.at(x, y + 1) + corners.at(x + 1, y + 1));
            result.errors.at(x, y) = Color(NAN, NAN, NAN);
        }
    }
    return result;
}

}  // namespace sw
