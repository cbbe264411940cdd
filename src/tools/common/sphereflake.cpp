#include "tools/common/sphereflake.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace scenes {
namespace {

using glm::dvec3;

using Directions = std::array<dvec3, 9>;

dvec3 direction(double azimuth, double latitude) {
    const double a = glm::radians(azimuth);
    return {std::cos(latitude) * std::cos(a), std::cos(latitude) * std::sin(a), std::sin(latitude)};
}

// The directions of the children of a sphere that grows along z: those of its neighbours in the
// densest packing of equal spheres, without the three below.
Directions childDirections() {
    const double upper = std::asin(std::sqrt(2.0 / 3));
    Directions result;
    for (std::size_t i = 0; i < 6; ++i) result[i] = direction(15 + 60 * static_cast<double>(i), 0);
    for (std::size_t i = 0; i < 3; ++i)
        result[6 + i] = direction(45 + 120 * static_cast<double>(i), upper);
    return result;
}

// Applies to v the shortest rotation of the z axis onto the unit vector `to` (Rodrigues' formula,
// with 1 - cos = sin^2 / (1 + cos)).
dvec3 turned(const dvec3& v, const dvec3& to) {
    if (1 + to.z < 1e-9) return {-v.x, v.y, -v.z};  // all rotations are equally short: about y
    const dvec3 axis = glm::cross(dvec3(0, 0, 1), to);
    const dvec3 moved = glm::cross(axis, v);
    return v + moved + glm::cross(axis, moved) / (1 + to.z);
}

}  // namespace

std::vector<Ball> sphereflake(std::size_t count, const dvec3& up) {
    const Directions children = childDirections();
    std::vector<Ball> balls{{{0, 0, 0}, 0.5}};
    std::vector<dvec3> ups{up};
    for (std::size_t parent = 0; balls.size() < count; ++parent) {
        const Ball from = balls[parent];
        const dvec3 along = ups[parent];
        for (const dvec3& child : children) {
            const dvec3 way = glm::normalize(turned(child, along));
            balls.push_back({from.center + 4.0 / 3 * from.radius * way, from.radius / 3});
            ups.push_back(way);
        }
    }
    balls.resize(count);
    return balls;
}

}  // namespace scenes
