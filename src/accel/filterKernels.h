#pragma once

// Filters: which of eight shapes does a ray miss for certain, and which does it hit for certain?
// They compute in float, eight shapes at a time, with margins for every rounding error. So they
// never contradict the exact kernels, such as Sphere::intersect, which decide all other cases.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "accel/filterRay.h"
#include "accel/simd.h"
#include "swCone.h"
#include "swNumerics.h"

// A filter has two answers, with one bit per shape: missed() for certain, and hit() for certain.

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

// Where a ray meets the planes of eight triangles, without divisions (Moller and Trumbore, Fast,
// Minimum Storage Ray/Triangle Intersection, 1997). With g from the origin to the corner v0 and the
// normal n = e1 x e2, the point at t = n.g / det, det = n.d, is v0 + v / det e1 + w / det e2 for
// v = (g x d).e2 and w = -(g x d).e1. With components of d up to 1, of g up to G and of the edges
// up to E, counting the roundings of each term gives |error| <= 42u G E for v and w. If the normal
// is computed in float, too, the roundings add up to 42u E^2 for det and 48u G E^2 for n.g.
class TriangleFilter {
public:
    SW_INLINE TriangleFilter(const FilterRay& ray, const Float3& v0, const Float3& e1,
                             const Float3& e2, const Float& extent)
        : TriangleFilter(ray, v0 - spread(ray.orig), e1, e2, cross(e1, e2), extent) {
        t = flipSign(dot(n, g), signedDet);
        tError = bound(64, largest(g) * (extent * extent));
    }

    unsigned missed() const { return bits(signKnown & (off() | (v + w > most()))); }
    // det > detError means an area that Triangle::intersect accepts.
    unsigned hit() const { return bits(on() & (least() > v + w)); }

protected:
    // The caller sets t and tError.
    SW_INLINE TriangleFilter(const FilterRay& ray, const Float3& g, const Float3& e1,
                             const Float3& e2, const Float3& n, const Float& extent)
        : ray(ray), g(g), n(n) {
        const Float3 d = spread(ray.dir), m = cross(g, d);
        signedDet = dot(n, d);
        det = abs(signedDet);
        v = flipSign(dot(m, e2), signedDet);
        w = broadcast(0) - flipSign(dot(m, e1), signedDet);
        detError = bound(64, extent * extent);
        vwError = bound(64, largest(g) * extent);
        signKnown = det > detError;
    }

    // v < 0, w < 0, or t outside the ray's range: minT det <= t <= maxT det, where the error of det
    // counts at both ends.
    Mask off() const {
        const Float none = broadcast(0) - vwError;
        const Float early = broadcast(ray.minT) * det - abs(broadcast(ray.minT)) * detError;
        const Float late = broadcast(ray.maxT) * (det + detError);
        return (none > v) | (none > w) | (early > t + tError) | (t - tError > late);
    }
    // The opposite, for certain.
    Mask on() const {
        const Float early = broadcast(ray.sureMinT()) * (det + detError);
        const Float late = broadcast(ray.sureMaxT()) * (det - detError);
        return signKnown & (v > vwError) & (w > vwError) & (t - tError > early) &
               (late > t + tError);
    }
    // Bounds of v, w or their sum, for a comparison with det.
    Float most() const { return det + (detError + 2 * vwError); }
    Float least() const { return det - (detError + 2 * vwError); }

    const FilterRay& ray;
    Float3 g, n;
    Float det, v, w, t;
    Float detError, vwError, tError;
    Float signedDet;
    Mask signKnown;  // if not, nothing is known
};

// Eight spheres. f: from their centres to the origin. The ray's line passes a centre at t = -k,
// k = f.d / a, a = d.d, in the distance |p|, p = f - k d. As |d| lies in [1/2, 1.74] and |f| is at
// most 1.74 |k| + |p|, k is off by at most 19u |k| + 8u |p|, and p by 40u (|k| + |p|).
class SphereFilter {
public:
    SW_INLINE SphereFilter(const FilterRay& ray, const Float3& f, const Float& radius)
        : ray(ray), radius(radius), r(abs(radius)) {
        const Float3 d = spread(ray.dir);
        const Float ff = dot(f, f), rr = r * r;
        k = dot(f, d) * ray.inverseSquared;
        const Float3 p = {f.x - k * d.x, f.y - k * d.y, f.z - k * d.z};
        pp = dot(p, p);
        slack = bound(48, abs(k) + r);
        outside = ff - rr - bound(8, ff + rr);
    }

    unsigned missed() const {
        const Mask passes = pp > (r + slack) * (r + slack) * (1 + 8 * u);
        // Behind: the ray starts outside and moves away from the centre.
        const Float start = broadcast(ray.minT >= 0 ? 0 : HUGE_VALF);
        const Mask behind = (k > start + slack) & (outside > broadcast(0));
        // Beyond: every point of the sphere has a t of at least -k - r / |d|.
        const Mask beyond = broadcast(0) - k - 2 * r - slack > broadcast(ray.maxT);
        return bits(passes | behind | beyond);
    }

    // Entered from outside, not before (f.f - r^2) / -2 f.d, and not after -k.
    unsigned hit() const {
        const Float least = r - slack, way = slack - k;
        const Float early = broadcast(ray.sureMinT()) * way * (2 * ray.dirSquared);
        return bits((radius > broadcast(0)) & (least > broadcast(0)) &
                    (least * least * (1 - 8 * u) > pp) & (k + slack < broadcast(0)) &
                    (outside > early) & (broadcast(ray.sureMaxT()) > way));
    }

private:
    const FilterRay& ray;
    Float radius, r, k, pp, slack;
    Float outside;  // positive: the origin is, for certain
};

// The endless cylinder and the sphere around a cone.
struct CylinderAround {
    Vec3 center, axis;    // of the axis: its middle and its direction
    float radius, reach;  // of the cylinder and of the sphere

    // Rounding moves the centre by 2u max|center| at most, and the axis by u times its length at
    // the ends: the radii make up for both.
    explicit CylinderAround(const Cone& cone) {
        const glm::dvec3 base = num::toDouble(cone.base), apex = num::toDouble(cone.apex);
        const double height = glm::length(apex - base);
        const double wide = std::max(std::fabs(cone.baseRadius), std::fabs(cone.apexRadius));
        center = num::toFloat(0.5 * (base + apex));
        axis = num::toFloat((apex - base) / height);
        const double slack = 4 * u * (num::maxAbs(center) + height);
        radius = static_cast<float>((wide + slack) * (1 + 4 * u));
        reach = static_cast<float>((std::hypot(0.5 * height, wide) + slack) * (1 + 4 * u));
    }
};

// Eight cones by the cylinders and spheres around them. f: from their centres to the origin. The
// axis is |f.g| / |g| away from the ray's line, where g = d x axis. With components of d and of the
// axis up to 1 and of f up to F, |error| <= 36u F for f.g and 48u for g.g.
class ConeFilter {
public:
    SW_INLINE ConeFilter(const FilterRay& ray, const Float3& f, const Float3& axis,
                         const Float& radius, const Float& reach)
        : sphere(ray, f, reach) {
        const Float3 g = cross(spread(ray.dir), axis);
        const Float apart = abs(dot(f, g)) - bound(48, largest(f));
        const Float gg = dot(g, g) + broadcast(64 * u);
        passes = (apart > broadcast(0)) &
                 (apart * apart > radius * radius * gg * (1 + 8 * u) + smallest);
    }

    unsigned missed() const { return bits(passes) | sphere.missed(); }
    unsigned hit() const { return 0; }  // never certain

private:
    SphereFilter sphere;
    Mask passes;
};

}  // namespace
}  // namespace sw
