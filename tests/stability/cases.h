#pragma once

#include <sstream>
#include <string>

#include "support.h"
#include "swSphere.h"
#include "swTriangle.h"

namespace sw {

inline std::ostream& operator<<(std::ostream& out, const Ray& ray) {
    return out << "ray " << ray.orig << ' ' << ray.dir << ' ' << ray.minT << ' ' << ray.maxT;
}
inline std::ostream& operator<<(std::ostream& out, const Sphere& sphere) {
    return out << "sphere " << sphere.center << ' ' << sphere.radius;
}
inline std::ostream& operator<<(std::ostream& out, const Triangle& triangle) {
    const Vec3* v = triangle.vertices;
    return out << "triangle " << v[0] << ' ' << v[1] << ' ' << v[2];
}

}  // namespace sw

namespace test {

/// How many random cases every family of properties is tried on, at least.
constexpr int familySize = 20000;

/// One line from values and words; floats can be read back without loss.
template <typename... Parts>
std::string describe(const Parts&... parts) {
    std::ostringstream out;
    out.precision(9);
    ((out << parts << ' '), ...);
    return out.str();
}

/// Checks a property on random cases. Catch2 takes microseconds per assertion, so this is one.
/// @param property  called with test::Random, a generator of its own for every case; returns what
///                  is wrong, or an empty string where the property holds
template <typename Property>
void checkRandomCases(int count, Property property) {
    int violations = 0;
    std::string first;
    for (int seed = 0; seed < count; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const std::string problem = property(random);
        if (!problem.empty() && violations++ == 0)
            first = "seed " + std::to_string(seed) + ": " + problem;
    }
    INFO("first of " << violations << " in " << count << ": " << first);
    CHECK(violations == 0);
}

/// A unit direction; one in four is parallel to an axis, its zeros of either sign.
inline Vec3 anyDirection(Random& random) {
    if (random.whole(0, 3) != 0) return random.direction();
    Vec3 v;
    for (float& x : v.m) x = random.coin() ? 0.0f : -0.0f;
    v[random.whole(0, 2)] = random.coin() ? 1.0f : -1.0f;
    return v;
}

/// A length unit: scenes in it have coordinates from 2^-30 on, or up to 2^30 times as large.
inline float anyScale(Random& random) {
    return std::ldexp(1.0f, random.whole(-30, 30));
}

/// Moves p by a distance along v, computed in double.
inline Vec3 moved(const Vec3& p, const Vec3& v, double distance) {
    return sw::num::toFloat(toDouble(p) + distance * toDouble(v));
}

/// Some unit vector at right angles to a unit vector.
inline Vec3 across(Random& random, const Vec3& v) {
    const dvec3 n = toDouble(v);
    for (;;) {
        const dvec3 c = glm::cross(n, toDouble(random.direction()));
        if (glm::length(c) > 0.1) return sw::num::toFloat(glm::normalize(c));
    }
}

/// The ray from a point through another, with a direction of any length from 1e-20 to 1e20.
inline sw::Ray rayThrough(Random& random, const Vec3& from, const Vec3& to) {
    const dvec3 d = toDouble(to) - toDouble(from);
    const double size = random.coin() ? 1 : random.magnitude(1e-20, 1e20);
    const double length = glm::length(d);
    return {from, length > 0 ? sw::num::toFloat(size / length * d) : random.direction()};
}

}  // namespace test
