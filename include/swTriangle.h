#pragma once

#include "swPrimitive.h"

namespace sw {

/// A triangle, hit from both sides. From its front the vertices run counter-clockwise: the outward
/// normal is (v1 - v0) % (v2 - v0). A triangle without area, or with a vertex that is not finite,
/// is never hit.
class Triangle : public Primitive {
public:
    Vec3 vertices[3];

    Triangle() = default;
    /// @param v  three vertices, which are copied
    Triangle(const Vec3* v, const Material& material)
        : Primitive(material), vertices{v[0], v[1], v[2]} {}

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override;
};

}  // namespace sw
