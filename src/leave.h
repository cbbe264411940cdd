#pragma once

#include "swIntersection.h"
#include "swNumerics.h"

/// Rays that leave a surface.
namespace sw {

/// Whether the surface is bent: whether it shades with another normal than its own.
inline bool isBent(const Intersection& hit) {
    return !hit.geometricNormal.isZero();
}

/// The surface's own normal, on the side that the ray came from.
inline const Vec3& trueNormal(const Intersection& hit) {
    return isBent(hit) ? hit.geometricNormal : hit.normal;
}

/// A ray that starts at the hit point, just so far off the surface that it does not meet it again.
/// @param side  a unit normal of the surface; the ray starts on the side to which it points
inline Ray leave(const Intersection& hit, const Vec3& side, const Vec3& direction, RayKind kind) {
    const Vec3 origin = num::offsetFromSurface(hit.position, side, num::statedOrDefaultError(hit));
    return Ray(origin, direction, 0, FLT_MAX, kind);
}

}  // namespace sw
