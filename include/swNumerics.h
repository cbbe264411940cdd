#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "swVec3.h"

/// Bounds on rounding errors. Kernels compute in double; points and normals are floats.
namespace sw::num {

/// Unit roundoff of float: a rounded result is off by at most this fraction of itself.
constexpr float unitRoundoff = 0x1p-24f;

inline glm::dvec3 toDouble(const Vec3& v) {
    return {v.m[0], v.m[1], v.m[2]};
}

inline Vec3 toFloat(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// v scaled to unit length; `fallback` if v has no direction.
inline glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& fallback) {
    const double length = glm::length(v);
    return length > 0 && length < HUGE_VAL ? v / length : fallback;
}

/// The largest component's magnitude.
inline float maxAbs(const Vec3& v) {
    const float x = std::fabs(v.m[0]), y = std::fabs(v.m[1]), z = std::fabs(v.m[2]);
    const float xy = x > y ? x : y;  // faster than std::fmax, a function call
    return xy > z ? xy : z;
}

/// Bound for Intersection::positionError of a primitive that computes in double.
/// @param position  the hit point, rounded to float from (nearly) exact coordinates
/// @param extent    at least the distance between any two points of the primitive
///
/// Rounding moves the position by u |p_i| per axis: at most sqrt(3) u max|p| along the normal.
/// A spawned direction that should leave the surface can dip below it by 3u: u from rounding the
/// direction, u from rounding the normal, u from deciding the side by that normal. Across the
/// primitive it dips by 3u extent. Both are rounded up to 4u. Nothing here is an absolute length: a
/// scene in millimetres and one in light years look the same.
inline float surfaceError(const Vec3& position, float extent) {
    return 4 * unitRoundoff * (maxAbs(position) + extent);
}

/// Moves a point off a surface, rounding every coordinate away from it (Pharr, Jakob and
/// Humphreys, Physically Based Rendering, 3rd ed., section 3.9.5, "Robust spawned ray origins").
/// @param point     on the surface, within `distance` of it
/// @param normal    unit normal on the side to move to
/// @param distance  how far, not negative
/// @return          a point at least `distance` away along the normal
Vec3 offsetFromSurface(const Vec3& point, const Vec3& normal, float distance);

}  // namespace sw::num
