#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tools/generators/nffText.h"
#include "tools/generators/scenes.h"

namespace scenes {
namespace {

using Directions = std::array<dvec3, 9>;

dvec3 direction(double azimuth, double latitude) {
    const double a = glm::radians(azimuth);
    return {std::cos(latitude) * std::cos(a), std::cos(latitude) * std::sin(a), std::sin(latitude)};
}

// Where the children of a sphere stand that grows along z: where its neighbours are in the densest
// packing of equal spheres, but for the three below.
Directions childDirections() {
    const double upper = std::asin(std::sqrt(2.0 / 3));
    Directions result;
    for (std::size_t i = 0; i < 6; ++i) result[i] = direction(15 + 60 * static_cast<double>(i), 0);
    for (std::size_t i = 0; i < 3; ++i)
        result[6 + i] = direction(45 + 120 * static_cast<double>(i), upper);
    return result;
}

// Turns v as the shortest way turns the z axis to the unit vector `to` (Rodrigues' formula, with
// 1 - cos = sin^2 / (1 + cos)).
dvec3 turned(const dvec3& v, const dvec3& to) {
    if (1 + to.z < 1e-9) return {-v.x, v.y, -v.z};  // every way down is as short: about y
    const dvec3 axis = glm::cross(dvec3(0, 0, 1), to);
    const dvec3 moved = glm::cross(axis, v);
    return v + moved + glm::cross(axis, moved) / (1 + to.z);
}

void grow(NffText& text, int size, const dvec3& center, double radius, const dvec3& up) {
    static const Directions children = childDirections();
    text.sphere(center, radius);
    if (size == 0) return;
    for (const dvec3& child : children) {
        const dvec3 way = glm::normalize(turned(child, up));
        grow(text, size - 1, center + 4.0 / 3 * radius * way, radius / 3, way);
    }
}

}  // namespace

std::string balls(int size) {
    NffText text({2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1});
    text.light({4, 3, 2});
    text.light({1, -4, 4});
    text.light({-3, 1, 5});
    text.material({1, 0.75, 0.33}, 0.8, 0);
    text.square({12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5});
    text.material({1, 0.9, 0.7}, 0.5, 0.5);
    grow(text, size, {0, 0, 0}, 0.5, {0, 0, 1});
    return text.take();
}

}  // namespace scenes
