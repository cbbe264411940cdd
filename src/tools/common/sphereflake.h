#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace scenes {

struct Ball {
    glm::dvec3 center;
    double radius;
};

/// A ball of radius 0.5 at the origin with nine smaller ones on it, each with nine on it and so on,
/// breadth first, up to `count` balls (Haines, A Proposal for Standard Graphics
/// Environments, 1987). The same arguments always give the same balls.
/// @param count  at least 1
/// @param up     unit vector along which the first one grows: three of its nine children are on
///               that side, the others around its equator
std::vector<Ball> sphereflake(std::size_t count, const glm::dvec3& up);

}  // namespace scenes
