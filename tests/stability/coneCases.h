#pragma once

#include "stability/cases.h"
#include "swCone.h"

namespace sw {

inline std::ostream& operator<<(std::ostream& out, const Cone& cone) {
    return out << "cone " << cone.base << ' ' << cone.baseRadius << ' ' << cone.apex << ' '
               << cone.apexRadius;
}

}  // namespace sw

namespace test {

using sw::Cone;
using sw::Ray;

/// A cone and a ray that is hard on it.
struct ConeCase {
    Cone cone;
    Ray ray;
};

inline dvec3 axisOf(const Cone& cone) {
    return glm::normalize(toDouble(cone.apex) - toDouble(cone.base));
}
inline double heightOf(const Cone& cone) {
    return glm::length(toDouble(cone.apex) - toDouble(cone.base));
}
/// At least the distance between any two points.
inline double extentOf(const Cone& cone) {
    return heightOf(cone) + 2.0 * std::max(std::fabs(cone.baseRadius), std::fabs(cone.apexRadius));
}

/// Cylinders, tips at either end, cones as flat as a disc or as long as a needle, of sizes from
/// 1e-8 to 1e8. One in four has negative radii.
inline Cone randomCone(Random& random, bool onlyPositive = false) {
    Cone cone;
    const float size = random.magnitude(1e-8, 1e8);
    cone.baseRadius = size * random.real(0.1, 1);
    const int kind = random.whole(0, 4);
    cone.apexRadius = kind == 0   ? cone.baseRadius
                      : kind == 1 ? 0
                      : kind == 2 ? cone.baseRadius * random.real(1 - 1e-6, 1 + 1e-6)
                                  : size * random.real(0.1, 1);
    const double height =
        size * (random.coin() ? random.real(0.1, 10) : random.magnitude(1e-6, 1e6));
    const double off = height + size;
    if (random.coin())
        cone.base = moved({0, 0, 0}, random.direction(), off * random.magnitude(0.1, 1e3));
    cone.apex = moved(cone.base, anyDirection(random), height);
    if (!(heightOf(cone) > 0)) cone.apex[0] += static_cast<float>(off);  // too flat to be there
    if (random.coin()) {
        std::swap(cone.base, cone.apex);
        std::swap(cone.baseRadius, cone.apexRadius);
    }
    if (!onlyPositive && random.whole(0, 3) == 0) {
        cone.baseRadius = -cone.baseRadius;
        cone.apexRadius = -cone.apexRadius;
    }
    return cone;
}

/// A point of the surface and the outward normal there.
struct SurfacePoint {
    dvec3 point, outwards, upwards;  ///< upwards: unit, along the mantle, from base to apex
};

/// @param up     0: on the base's circle, 1: on the apex's
/// @param aside  unit vector across the axis
inline SurfacePoint surfaceAt(const Cone& cone, double up, const dvec3& aside) {
    const double r = std::fabs(cone.baseRadius), growth = std::fabs(cone.apexRadius) - r;
    const double height = heightOf(cone), slant = std::hypot(height, growth);
    const dvec3 n = axisOf(cone);
    return {toDouble(cone.base) + up * height * n + (r + up * growth) * aside,
            (height * aside - growth * n) / slant, (height * n + growth * aside) / slant};
}

inline SurfacePoint anyPoint(Random& random, const Cone& cone) {
    const Vec3 aside = across(random, sw::num::toFloat(axisOf(cone)));
    const double up = random.coin()   ? random.uniform(0, 1)
                      : random.coin() ? random.magnitude(1e-9, 1)
                                      : 1 - random.magnitude(1e-9, 1);
    return surfaceAt(cone, up, glm::normalize(toDouble(aside)));
}

/// A ray from anywhere at a point of the cone or a little off it.
inline Ray fromAfar(Random& random, const Cone& cone) {
    const dvec3 point = anyPoint(random, cone).point;
    const double off = random.coin() ? 0 : random.magnitude(1e-12, 1);
    const double distance = random.magnitude(1e-3, random.coin() ? 10 : 1e7);
    const Vec3 target = moved(sw::num::toFloat(point), random.direction(), off * extentOf(cone));
    const Vec3 from = moved(target, anyDirection(random), distance * extentOf(cone));
    return rayThrough(random, from, target);
}

/// A ray that touches the cone, along the mantle or across it.
inline Ray tangent(Random& random, const Cone& cone) {
    const SurfacePoint p = anyPoint(random, cone);
    const dvec3 sideways = cross(p.outwards, p.upwards);
    const double turn = random.coin() ? 0 : random.uniform(-4, 4);
    const dvec3 along = std::cos(turn) * p.upwards + std::sin(turn) * sideways;
    const double off =
        (random.coin() ? 1 : -1) * (random.coin() ? random.magnitude(1e-16, 1e-3) : 0);
    const Vec3 target = sw::num::toFloat(p.point + off * extentOf(cone) * p.outwards);
    const double distance = random.magnitude(0.1, 1e4) * extentOf(cone);
    return rayThrough(random, moved(target, sw::num::toFloat(along), distance), target);
}

/// A ray along the axis or parallel to it.
inline Ray alongAxis(Random& random, const Cone& cone) {
    const Vec3 way = random.coin() ? cone.apex - cone.base : cone.base - cone.apex;
    const Vec3 side = across(random, sw::num::toFloat(axisOf(cone)));
    const double off = random.coin()
                           ? 0
                           : random.uniform(0, 1.1) *
                                 std::max(std::fabs(cone.baseRadius), std::fabs(cone.apexRadius));
    return Ray(moved(cone.base, side, off) - way * random.real(-2, 10),
               way * random.magnitude(1e-6, 1e6));
}

/// A ray between two points of the surface or near it, or from the axis.
inline Ray fromWithin(Random& random, const Cone& cone) {
    const Vec3 from = random.coin() ? sw::num::toFloat(anyPoint(random, cone).point)
                                    : moved(cone.base, sw::num::toFloat(axisOf(cone)),
                                            heightOf(cone) * random.uniform(0, 1));
    return rayThrough(random, from, sw::num::toFloat(anyPoint(random, cone).point));
}

inline Ray randomRay(Random& random, const Cone& cone) {
    switch (random.whole(0, 5)) {
        case 0:
            return tangent(random, cone);
        case 1:
            return alongAxis(random, cone);
        case 2:
            return fromWithin(random, cone);
        default:
            return fromAfar(random, cone);
    }
}

inline ConeCase randomConeCase(Random& random) {
    const Cone cone = randomCone(random);
    return {cone, randomRay(random, cone)};
}

}  // namespace test
