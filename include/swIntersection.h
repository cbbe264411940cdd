#pragma once

#include "swMaterial.h"
#include "swRay.h"
#include "swVec3.h"

namespace sw {

/// Where and how a ray hit a surface. Valid only after an intersect() that returned true.
struct Intersection {
    Vec3 position;            ///< hit point
    Vec3 normal;              ///< unit normal on the side that the ray came from
    float hitT = FLT_MAX;     ///< ray parameter of the hit, in units of ray.dir
    bool frontFacing = true;  ///< false: the ray came from inside or behind
    Material material;
    Ray ray;  ///< the ray that hit

    /// Unit normal of the true surface, on the same side, if `normal` is a shading normal. It
    /// decides what is above and below the surface: spawned rays start and stay on their side of
    /// it. Zero (the default): no shading normal was set, `normal` is the geometric one.
    Vec3 geometricNormal;

    /// How far `position` may lie from the true surface. The next ray must start that far off along
    /// the normal so as not to meet the same surface again. Negative (the default): the primitive
    /// states none, and a cautious bound takes its place, see errorBound().
    float positionError = -1;

    /// Sets frontFacing, and the normal on the side that the ray came from.
    /// @param outward      unit normal of the outside
    /// @param fromOutside  whether the ray came from there
    /// @param insideOut    true where the inside is the front, as with negative radii
    void setFace(const Vec3& outward, bool fromOutside, bool insideOut = false) {
        normal = fromOutside ? outward : -outward;
        frontFacing = fromOutside != insideOut;
    }

    bool hasShadingNormal() const { return !geometricNormal.isZero(); }
    /// Unit geometric normal, on the side that the ray came from.
    const Vec3& surfaceNormal() const { return hasShadingNormal() ? geometricNormal : normal; }

    /// The positionError, or a cautious bound if the primitive states none.
    ///
    /// The slides start their rays at t = 0.01, which suits the lab's scene of some 60 units. The
    /// bound keeps that proportion at every scale. It is 2^-14 times the lengths that the hit point
    /// was computed from: its coordinates and the distance to it. That is 1000 roundings, enough
    /// for textbook formulas in float at distances up to about 30 times the primitive's size.
    float errorBound() const;

    /// Ray that starts at the hit point, just far enough off the surface not to meet it again.
    /// @param direction  of any length but zero
    /// @param side       unit normal on the side where the ray goes on: `normal`, or `-normal` to
    ///                   pass through the surface
    /// @param kind       for the statistics alone
    Ray spawnRay(const Vec3& direction, const Vec3& side, RayKind kind) const;

    /// Ray from the hit point to a light. Its direction is not normalised, and maxT ends it just
    /// short of the light: anything that it hits is between point and light. It starts above the
    /// true surface, so the surface itself blocks light from behind.
    Ray getShadowRay(const Vec3& lightPos) const;

    /// Mirror-reflected ray; unit direction. If the shading normal would send it into the surface,
    /// it is reflected at the true surface.
    Ray getReflectedRay() const;

    /// Ray refracted by Snell's law; unit direction. Entering through the front divides by
    /// material.refractiveIndex, leaving through the back multiplies by it. On total internal
    /// reflection it takes the reflected direction. If the shading normal would send it to the
    /// wrong side, it is refracted at the true surface.
    Ray getRefractedRay() const;
};

}  // namespace sw
