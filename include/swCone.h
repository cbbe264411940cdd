#pragma once

#include "swPrimitive.h"

namespace sw {

/// The lateral surface of a truncated cone, without caps. It is a cylinder if the radii are equal,
/// and a full cone if one radius is 0. The axis is perpendicular to the end circles.
///
/// Positive radii: hit from outside (front) and from inside (back). Negative radii: only the inside
/// can be hit; it is the front, and rays from outside pass through. A cone is never hit if its
/// height is 0, both radii are 0, the radii have different signs, or a number is not finite.
class Cone : public Primitive {
public:
    Vec3 base;             ///< centre of one end
    float baseRadius = 1;  ///< radius there
    Vec3 apex{0, 1, 0};    ///< centre of the other end
    float apexRadius = 0;  ///< radius there; may be the larger one

    Cone() = default;
    Cone(const Vec3& base, float baseRadius, const Vec3& apex, float apexRadius,
         const Material& material)
        : Primitive(material),
          base(base),
          baseRadius(baseRadius),
          apex(apex),
          apexRadius(apexRadius) {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
