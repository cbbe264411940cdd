#pragma once

#include <cfloat>

#include "swVec3.h"

namespace sw {

/// Why a ray was cast. Used for statistics only.
enum class RayKind : unsigned char { primary, shadow, reflected, refracted, other };

/// The points orig + t * dir with minT < t < maxT.
struct Ray {
    Vec3 orig;
    Vec3 dir;  ///< of any length but zero; t counts in units of it
    float minT = 0;
    float maxT = FLT_MAX;
    RayKind kind = RayKind::other;

    Ray() = default;
    Ray(const Vec3& origin, const Vec3& direction, float minT = 0, float maxT = FLT_MAX,
        RayKind kind = RayKind::other)
        : orig(origin), dir(direction), minT(minT), maxT(maxT), kind(kind) {}

    const Vec3& origin() const { return orig; }
    const Vec3& direction() const { return dir; }

    /// The point orig + t * dir.
    Vec3 at(float t) const { return orig + t * dir; }
    /// True if minT < t < maxT; false if t is NaN.
    bool contains(float t) const { return minT < t && t < maxT; }
};

}  // namespace sw
