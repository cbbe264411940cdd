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

    /// Unit normal of the true surface, on the same side, where `normal` was bent so that a flat
    /// piece shades like a round one. It tells above from below: spawned rays start and stay on
    /// their side of it. Zero, as primitives leave it that bend nothing: the same as `normal`.
    Vec3 geometricNormal;

    /// How far `position` may lie from the true surface, and how far along the normal the next ray
    /// must start so as not to meet the same surface again. Negative where the primitive does not
    /// say: then a cautious default takes its place (num::statedOrDefaultError).
    float positionError = -1;

    /// Ray from the hit point to a light. Its direction is not normalised, and maxT ends it just
    /// short of the light: whatever it hits stands between point and light.
    /// It starts above the true surface, so light from behind is blocked by the surface itself.
    Ray getShadowRay(const Vec3& lightPos) const;

    /// Ray that leaves the hit point as from a mirror; unit direction. Where a bent normal would
    /// send it into the surface, it is mirrored at the true surface.
    Ray getReflectedRay() const;

    /// Ray that leaves the hit point by Snell's law; unit direction. Entering through the front
    /// divides by material.refractiveIndex, leaving through the back multiplies with it.
    /// On total internal reflection it is the reflected direction. Where a bent normal would send
    /// it to the wrong side, it is refracted at the true surface.
    Ray getRefractedRay() const;
};

}  // namespace sw
