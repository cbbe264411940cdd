#pragma once

#include "swSphere.h"
#include "swTriangle.h"

namespace report {

/// The truth about a ray and a shape, for exactly these floats.
struct Truth {
    bool certain;  ///< false: too close to call even in 113 bits. Then the rest means nothing
    bool hit;
    long double t;  ///< of the nearest hit with t > 0
};

/// Computes in __float128 (where the compiler has it, else long double), and calls a decision
/// certain only where the bound on the rounding errors allows no other.
Truth exactHit(const sw::Sphere& sphere, const sw::Ray& ray);
Truth exactHit(const sw::Triangle& triangle, const sw::Ray& ray);

}  // namespace report
