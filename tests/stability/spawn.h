#pragma once

#include "stability/cases.h"
#include "stability/exact.h"

namespace test {

inline sw::Material anyGlass(Random& random) {
    const float index = random.coin() ? random.real(0.4, 2.5) : random.real(1 - 1e-6, 1 + 1e-6);
    return sw::Material({1, 1, 1}, 0.5f, 0.5f, index);
}

/// Whether the refracted ray of a hit is a reflected one: it starts in the same place. Directions
/// tell less, as along a surface both are the same float by float.
inline bool isTotal(const sw::Ray& refracted, const sw::Intersection& hit) {
    return distance(refracted.orig, hit.getReflectedRay().orig) == 0;
}

/// Spawned rays start off the surface, but near: by twice the error that surfaceError states.
inline bool startsNear(const sw::Ray& ray, const sw::Intersection& hit, double extent) {
    using exact::Real3;
    const exact::Real moved = exact::length(Real3(ray.orig) - Real3(hit.position));
    return moved <= 8 * u * (sw::num::maxAbs(hit.position) + extent);
}

/// What rounding may do to a shadow ray: its direction, its end just short of the light.
inline exact::Real shadowMargin(const sw::Intersection& hit, const Vec3& light, double extent) {
    using exact::Real3;
    return 16 * u *
           (exact::length(Real3(hit.position)) + exact::length(Real3(light)) + exact::Real(extent));
}

}  // namespace test
