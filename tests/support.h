#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <ostream>
#include <random>

#include "catch.h"
#include "swIntersection.h"
#include "swNumerics.h"
#include "swPrimitive.h"
#include "swVec3.h"

namespace sw {

/// So that Catch2 can show vectors.
inline std::ostream& operator<<(std::ostream& out, const Vec3& v) {
    return out << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
}

}  // namespace sw

namespace test {

using glm::dvec3;
using sw::Color;
using sw::Vec3;
using sw::num::toDouble;

/// u: half the distance from 1 to the next float.
constexpr double u = 0x1p-24;

/// Random cases, the same for the same seed on every platform.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine(seed) {}

    /// In [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    float real(double low, double high) { return static_cast<float>(uniform(low, high)); }
    /// Every magnitude between low and high is equally likely; both are positive.
    float magnitude(double low, double high) {
        return static_cast<float>(std::exp(uniform(std::log(low), std::log(high))));
    }
    int whole(int low, int high) {  ///< in [low, high]
        return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool coin() { return (engine() >> 63) != 0; }

    /// In the cube of that half side length.
    Vec3 point(double side) { return {real(-side, side), real(-side, side), real(-side, side)}; }
    /// Uniform on the unit sphere.
    Vec3 direction();

private:
    std::mt19937_64 engine;
};

/// Whether two vectors are equal; never with NaN.
inline bool isSame(const Vec3& a, const Vec3& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/// Whether a ray hits, and where: NaN if nowhere.
inline bool isHit(const sw::Primitive& shape, const sw::Ray& ray) {
    sw::Intersection hit;
    return shape.intersect(ray, hit);
}
inline float hitT(const sw::Primitive& shape, const sw::Ray& ray) {
    sw::Intersection hit;
    return shape.intersect(ray, hit) ? hit.hitT : NAN;
}

/// Largest difference of two vectors' coordinates.
inline double distance(const Vec3& a, const dvec3& b) {
    const dvec3 d = abs(toDouble(a) - b);
    return std::max(d.x, std::max(d.y, d.z));
}
inline double distance(const Vec3& a, const Vec3& b) {
    return distance(a, toDouble(b));
}

}  // namespace test
