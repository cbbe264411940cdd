#pragma once

#include "swPrimitive.h"

namespace sw {

/// A sphere, hit from outside (front) and from inside (back). Of one with a negative radius only
/// the inside can be seen; that is its front, and from outside rays go through.
/// One whose radius is 0 or not finite is never hit.
class Sphere : public Primitive {
public:
    Vec3 center;
    float radius = 1;

    Sphere() = default;
    Sphere(const Vec3& middle, float size, const Material& surface)
        : Primitive(surface), center(middle), radius(size) {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
