#pragma once

#include <cmath>

#include "swNumerics.h"
#include "swSampling.h"

/// Random geometry from the library's own generator; sw::seedPixel starts it.
namespace report {

using glm::dvec3;

/// In [low, high).
inline double between(double low, double high) {
    return low + (high - low) * static_cast<double>(sw::uniform());
}

/// Every magnitude between low and high is equally likely; both are positive.
inline double magnitude(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
}

/// In the cube of that half side length.
inline dvec3 inCube(double side) {
    const double x = between(-side, side), y = between(-side, side);
    return {x, y, between(-side, side)};
}

/// Uniform on the unit sphere.
inline dvec3 direction() {
    for (;;) {
        const dvec3 v = inCube(1);
        const double l = length(v);
        if (l > 0.01 && l < 1) return v / l;
    }
}

/// A random unit vector at right angles to v, which is not zero.
inline dvec3 perpendicular(const dvec3& v) {
    return normalize(cross(v, direction()));
}

}  // namespace report
