#pragma once

// Filters: which of eight shapes may a ray hit? They compute in float, eight shapes at a time, and
// err on one side only: with margins for every rounding error, they never miss a shape that the
// exact kernel would hit. What they let through goes to Sphere::intersect or Triangle::intersect.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "accel/filterRay.h"
#include "accel/simd.h"
#include "swNumerics.h"

namespace sw {
namespace {  // compiled with fused multiply-adds or without them: no symbols to share

using namespace simd;

constexpr float u = num::unitRoundoff;

// Below this, products may have lost digits to underflow: then nothing is rejected.
constexpr float smallest = 0x1p-100f;

struct Float3 {
    Float x, y, z;
};

inline Float3 spread(const Vec3& v) {
    return {broadcast(v.m[0]), broadcast(v.m[1]), broadcast(v.m[2])};
}

inline Float3 loadRows(const float* row, std::size_t stride) {
    return {load(row), load(row + stride), load(row + 2 * stride)};
}

inline Float3 operator-(const Float3& a, const Float3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Float dot(const Float3& a, const Float3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Float3 cross(const Float3& a, const Float3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Float largest(const Float3& a) {
    return max(max(abs(a.x), abs(a.y)), abs(a.z));
}

// An error bound of a few u times x. It is infinite, so that nothing is rejected, if terms of the
// size of x come near the end of the range: their sums may have overflowed.
inline Float bound(float roundings, Float x) {
    return x * 0x1p20f * (roundings * u * 0x1p-20f) + broadcast(smallest);
}

// Of a triangle's two edges.
inline float longestComponent(const Vec3& e1, const Vec3& e2) {
    return std::max(num::maxAbs(e1), num::maxAbs(e2));
}

// Where a ray meets the planes of eight triangles v0 + v / det e1 + w / det e2, without divisions
// (Moller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997). With components of
// d up to 1, of s up to S and of the edges up to E, counting the roundings of each term gives
// |error| <= 42u E^2 for det, 42u S E for v and w, 48u S E^2 for t.
struct PlaneHits {
    Float det, v, w;
    Float detError, vwError;
    Mask signKnown;  // of det; if it is not, nothing is rejected
    Mask off;        // v < 0 or w < 0, or t outside the ray's range

    PlaneHits(const FilterRay& ray, const Float3& v0, const Float3& e1, const Float3& e2,
              const Float& extent) {
        const Float3 d = spread(ray.dir);
        const Float3 s = spread(ray.orig) - v0;
        const Float3 p = cross(d, e2);
        const Float3 q = cross(s, e1);
        const Float signedDet = dot(e1, p);
        det = abs(signedDet);
        v = flipSign(dot(s, p), signedDet);
        w = flipSign(dot(d, q), signedDet);
        const Float t = flipSign(dot(e2, q), signedDet);

        const Float area = largest(s) * extent;
        const Float tError = bound(64, area * extent);
        detError = bound(64, extent * extent);
        vwError = bound(64, area);
        signKnown = det > detError;
        // minT det <= t <= maxT det; the error of det counts at both ends.
        const Float early = broadcast(ray.minT) * det - abs(broadcast(ray.minT)) * detError;
        const Float late = broadcast(ray.maxT) * (det + detError);
        const Float none = broadcast(0) - vwError;
        off = (none > v) | (none > w) | (early > t + tError) | (t - tError > late);
    }
};

// Which of eight spheres of radius r >= 0 a ray cannot hit. f: from their centres to its origin.
// The discriminant is b^2 - a (f.f - r^2); every product in it is at most a (f.f + r^2) and has
// gone through at most 12 roundings, those of a, f and b included: 32u covers both terms.
inline Mask spheresMissed(const FilterRay& ray, const Float3& f, const Float& r) {
    const Float a = broadcast(ray.dirSquared);
    const Float b = dot(f, spread(ray.dir));
    const Float ff = dot(f, f);
    const Float rr = r * r;
    const Float sum = ff + rr;
    const Mask missed = b * b + bound(32, a * sum) < a * (ff - rr);

    // Behind: the ray starts outside and moves away from the centre. |f| |d| <= (f.f + a) / 2.
    const Float start = broadcast(ray.minT >= 0 ? 0 : HUGE_VALF);
    const Float error = bound(8, ff + a + r);
    const Mask behind = (b > start + error) & (ff - rr > bound(8, sum));

    // Beyond: every point of the sphere has a t of at least (-b - r |d|) / a, and |d| < 2.
    const Float end = broadcast(ray.maxT) * a;
    const Float nearest = broadcast(0) - b - 2 * r;
    const Mask beyond = nearest - error > end * (1 + 8 * u);
    return missed | behind | beyond;
}

}  // namespace
}  // namespace sw
