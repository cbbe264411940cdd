#pragma once

#include "swTriangle.h"

namespace sw {

/// A smooth-shaded triangle. The `normal` of a hit is a shading normal, interpolated between the
/// normals at the vertices (Phong, Illumination for Computer Generated Pictures, 1975). Everything
/// else is the triangle's, above all its front side and `geometricNormal`.
///
/// Near a silhouette the interpolated normal may point below the triangle, or away from the ray.
/// There `normal` is the triangle's own.
class Patch : public Primitive {
public:
    Triangle triangle;  ///< the surface; its material is ignored
    Vec3 normals[3];    ///< unit normals on the front side, one for each vertex

    Patch() = default;
    /// @param v  three vertices
    /// @param n  their normals, of any length. If one is zero or not finite, the triangle's normal
    ///           replaces it.
    Patch(const Vec3* v, const Vec3* n, const Material& material);

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override { return triangle.bounds(); }
};

}  // namespace sw
