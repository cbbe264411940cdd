#pragma once

#include <cfloat>

#include "swVec3.h"

namespace sw {

/// Why a ray was cast. Only statistics look at it.
enum class RayKind : unsigned char { primary, shadow, reflected, refracted, other };

/// The points orig + t * dir with minT < t < maxT.
struct Ray {
    Vec3 orig;
    Vec3 dir;  ///< of any length but zero; t counts in units of it
    float minT = 0;
    float maxT = FLT_MAX;
    RayKind kind = RayKind::other;

    Ray() = default;
    Ray(const Vec3& origin, const Vec3& direction, float after = 0, float before = FLT_MAX,
        RayKind why = RayKind::other)
        : orig(origin), dir(direction), minT(after), maxT(before), kind(why) {}

    const Vec3& origin() const { return orig; }
    const Vec3& direction() const { return dir; }
};

}  // namespace sw
