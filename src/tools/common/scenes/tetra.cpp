#include <array>

#include "tools/common/nffText.h"
#include "tools/common/scenes/scenes.h"

namespace scenes {
namespace {

using Corners = std::array<dvec3, 4>;

void divide(NffText& text, int size, const Corners& c) {
    if (size == 1) {
        text.triangle(c[0], c[1], c[2]);
        text.triangle(c[0], c[2], c[3]);
        text.triangle(c[0], c[3], c[1]);
        text.triangle(c[1], c[3], c[2]);
        return;
    }
    for (const dvec3& corner : c) {
        Corners half;
        for (std::size_t i = 0; i < 4; ++i) half[i] = (corner + c[i]) / 2.0;
        divide(text, size - 1, half);
    }
}

}  // namespace

std::string tetra(int size) {
    NffText text({1.02285, -3.17715, -2.17451}, {-0.004103, -0.004103, 0.216539},
                 {-0.816497, -0.816497, 0.816497});
    text.light({2, -18, -5});
    text.material({1, 0.2, 0.2}, 1, 0);
    divide(text, size, {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}});
    return text.take();
}

}  // namespace scenes
