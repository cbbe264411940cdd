#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "tools/common/nffText.h"
#include "tools/common/scenes/scenes.h"

namespace scenes {
namespace {

using Ring = std::array<dvec3, 5>;

constexpr double tubeRadius = 0.07412, outerRadius = 1.07412;  // of an object
constexpr double layerDistance = 2.61313;

dvec3 turned(const dvec3& p, double x, double z) {
    const dvec3 q(p.x, glm::cos(x) * p.y - glm::sin(x) * p.z,
                  glm::sin(x) * p.y + glm::cos(x) * p.z);
    return {glm::cos(z) * q.x - glm::sin(z) * q.y, glm::sin(z) * q.x + glm::cos(z) * q.y, q.z};
}

// Six pentagons through the midpoints of a dodecahedron's edges.
std::array<Ring, 6> ringsOfObject() {
    const double tilt = 2 * std::acos(glm::cos(glm::radians(60.0)) / glm::sin(glm::radians(36.0)));
    std::array<Ring, 6> rings;
    for (std::size_t k = 0; k < 5; ++k) {
        const double angle = glm::radians(72.0 * static_cast<double>(k));
        const dvec3 p = dvec3(glm::cos(angle), glm::sin(angle), 0) / outerRadius;
        rings[0][k] = p;
        for (std::size_t j = 0; j < 5; ++j)
            rings[j + 1][k] = turned(p, tilt, glm::radians(36 + 72.0 * static_cast<double>(j)));
    }
    return rings;
}

void writeRing(NffText& text, const Ring& ring, const dvec3& center) {
    for (std::size_t k = 0; k < 5; ++k) {
        text.sphere(center + ring[k], tubeRadius);
        text.cone(center + ring[(k + 4) % 5], tubeRadius, center + ring[k], tubeRadius);
    }
}

// A wall behind everything, 1 % wider than what the eye sees of it.
void writeWall(NffText& text, const dvec3& eye, double y) {
    const double half = 1.01 * (y - eye.y) * glm::tan(glm::radians(22.5));
    const double left = eye.x - half, right = eye.x + half, low = eye.z - half, top = eye.z + half;
    text.material({1, 1, 1}, 1, 0);
    text.square({left, y, low}, {right, y, low}, {right, y, top}, {left, y, top});
}

}  // namespace

std::string rings(int size) {
    const dvec3 eye(-1, -layerDistance, 0.5);
    NffText text(eye, eye + dvec3(0, 1, 0), {0, 0, 1});
    text.light({3, -layerDistance, 3});
    text.light({-4, -layerDistance, 1});
    text.light({2, -layerDistance, -4});
    writeWall(text, eye, layerDistance * (size + 1));
    const dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
    const std::array<Ring, 6> object = ringsOfObject();
    for (std::size_t ring = 0; ring < object.size(); ++ring) {
        text.material(colors[ring], 0.5, 0.2);
        for (int layer = 0; layer < size; ++layer)
            for (int i = 0; i <= layer; ++i)
                for (int j = 0; j <= layer; ++j)
                    writeRing(text, object[ring],
                              {2 * i - layer, layerDistance * (layer + 1), 2 * j - layer});
    }
    return text.take();
}

}  // namespace scenes
