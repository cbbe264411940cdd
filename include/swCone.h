#pragma once

#include "swPrimitive.h"

namespace sw {

/// The mantle of a cone, open at both ends: a truncated cone, a cylinder where the radii are equal,
/// a cone with a tip where one radius is 0. Its end circles stand at right angles to the axis.
///
/// Positive radii: hit from outside (front) and from inside (back). Negative radii: only the inside
/// can be seen; that is its front, and from outside rays go through. A cone of no height, of two
/// radii 0, of radii with different signs or of numbers that are not finite is never hit.
class Cone : public Primitive {
public:
    Vec3 base;             ///< centre of one end
    float baseRadius = 1;  ///< radius there
    Vec3 apex{0, 1, 0};    ///< centre of the other end
    float apexRadius = 0;  ///< radius there; may be the larger one

    Cone() = default;
    Cone(const Vec3& start, float startRadius, const Vec3& end, float endRadius,
         const Material& surface)
        : Primitive(surface),
          base(start),
          baseRadius(startRadius),
          apex(end),
          apexRadius(endRadius) {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
