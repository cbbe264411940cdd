#pragma once

#include "swSphere.h"
#include "swTriangle.h"

namespace report {

/// The truth about a ray and a shape, for exactly these floats.
struct Truth {
    bool certain;  ///< false: too close to call even with 113 bits; the rest is undefined
    bool hit;
    long double t;  ///< of the nearest hit with t > 0
};

/// Computes in __float128, or in long double if the compiler lacks it. A decision is certain only
/// if no rounding error within the bound could change it.
Truth exactHit(const sw::Sphere& sphere, const sw::Ray& ray);
Truth exactHit(const sw::Triangle& triangle, const sw::Ray& ray);

}  // namespace report
