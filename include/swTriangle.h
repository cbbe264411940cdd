#pragma once

#include "swPrimitive.h"

namespace sw {

/// A triangle, hit from both sides. Its front shows the vertices counter-clockwise: the outward
/// normal is (v1 - v0) % (v2 - v0). One of zero area or with a non-finite vertex is never hit.
class Triangle : public Primitive {
public:
    Vec3 vertices[3];

    Triangle() = default;
    /// @param v  three vertices, which are copied
    Triangle(const Vec3* v, const Material& surface)
        : Primitive(surface), vertices{v[0], v[1], v[2]} {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
