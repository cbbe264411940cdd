#pragma once

#include <cmath>

#include "support.h"

/// Arithmetic for oracles: 113 bits where the compiler has __float128 (gcc and clang on Linux),
/// long double elsewhere. Sums and products of floats are exact in it or nearly so.
namespace exact {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Real;
#else
using Real = long double;
#endif

/// How far the kernels may move the geometry, as a fraction of its distance.
///
/// The issue grants 8u = 2^-21 for float kernels. At a distance of 1e7 radii that is five radii,
/// and hardly any answer would be wrong. Our kernels compute in double from exact inputs, where a
/// difference, a product and a sum of three lose 4 x 2^-53 of the largest length that occurs; with
/// reserve for the rest of the formula 2^-46. What holds for this bound holds for the issue's.
constexpr double shift = 0x1p-46;

/// What a float result may be off by, relatively; half of it is lost in rounding to float.
constexpr double roundings = 8 * test::u;

inline Real abs(Real x) {
    return x < 0 ? -x : x;
}
inline Real min(Real x, Real y) {
    return x < y ? x : y;
}
inline Real max(Real x, Real y) {
    return x > y ? x : y;
}
/// Square root of a number within double's range, 0 for negative ones: Newton's iteration doubles
/// the 53 correct digits of std::sqrt to more than there are.
inline Real root(Real x) {
    const double estimate = x > 0 ? std::sqrt(static_cast<double>(x)) : 0;
    if (!(estimate > 0)) return 0;
    Real s = estimate;
    for (int i = 0; i < 2; ++i) s = (s + x / s) / 2;
    return s;
}

struct Real3 {
    Real x = 0, y = 0, z = 0;

    Real3() = default;
    Real3(Real a, Real b, Real c) : x(a), y(b), z(c) {}
    Real3(const sw::Vec3& v) : x(v[0]), y(v[1]), z(v[2]) {}
};

inline Real3 operator+(const Real3& a, const Real3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Real3 operator-(const Real3& a, const Real3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Real3 operator*(Real s, const Real3& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Real dot(const Real3& a, const Real3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Real3 cross(const Real3& a, const Real3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Real3& a) {
    return root(dot(a, a));
}
inline Real3 unit(const Real3& a) {
    return (1 / length(a)) * a;
}

/// Where a result may lie.
struct Interval {
    Real low, high;

    bool holds(Real x) const { return low <= x && x <= high; }
    bool within(const sw::Ray& ray) const { return ray.minT < low && high < ray.maxT; }
};

/// Lengths along a ray as values of hitT: in units of the direction, and rounded to float, where
/// the smallest are rounded absolutely.
inline Interval rayParameters(Real nearest, Real farthest, Real directionLength) {
    const Real low = nearest / directionLength, high = farthest / directionLength;
    return {low - roundings * abs(low) - 0x1p-149, high + roundings * abs(high) + 0x1p-149};
}

/// Distance of a point from the line of a ray.
inline Real distanceFromLine(const Real3& point, const sw::Ray& ray) {
    return length(cross(point - Real3(ray.orig), Real3(ray.dir))) / length(Real3(ray.dir));
}

}  // namespace exact
