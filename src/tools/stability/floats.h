#pragma once

#include <cmath>

#include "swIntersection.h"
#include "swNumerics.h"

/// Shared by the comparison kernels: plain float arithmetic, as on the slides.
namespace report {

using sw::Intersection;
using sw::Ray;
using sw::Vec3;

inline float length(const Vec3& v) {
    return std::sqrt(v * v);
}

/// Fills the record of a hit at t.
/// @param outward  the surface's normal, of any length
inline void fill(Intersection& hit, const Ray& ray, float t, const Vec3& position,
                 const Vec3& outward, bool front, float extent, const sw::Material& material) {
    hit.hitT = t;
    hit.position = position;
    hit.normal = outward * ((front ? 1.0f : -1.0f) / length(outward));
    hit.frontFacing = front;
    hit.material = material;
    hit.ray = ray;
    hit.positionError = sw::num::surfaceError(position, extent);
}

}  // namespace report
