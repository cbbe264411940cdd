#pragma once

#include "swPrimitive.h"

namespace sw {

/// A sphere, hit from outside (front) and from inside (back). If the radius is negative, only the
/// inside can be hit: it is the front, and rays from outside pass through. If the radius is 0 or
/// not finite, the sphere is never hit.
class Sphere : public Primitive {
public:
    Vec3 center;
    float radius = 1;

    Sphere() = default;
    Sphere(const Vec3& center, float radius, const Material& material)
        : Primitive(material), center(center), radius(radius) {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
