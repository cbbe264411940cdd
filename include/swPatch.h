#pragma once

#include "swTriangle.h"

namespace sw {

/// A triangle that looks round: `normal` of a hit is interpolated between a normal at each vertex
/// (Phong, Illumination for Computer Generated Pictures, 1975). All else, above all which side is
/// the front and `geometricNormal`, is the triangle's.
///
/// The triangle's own normal is taken where the interpolated one points below the triangle, or away
/// from the ray, as may happen near a silhouette.
class Patch : public Primitive {
public:
    Triangle triangle;  ///< where the surface is; its material is not looked at
    Vec3 normals[3];    ///< unit normals on the front side, one for each vertex

    Patch() = default;
    /// @param v  three vertices
    /// @param n  their normals, of any length. One that is zero or not finite stands for the
    ///           triangle's own.
    Patch(const Vec3* v, const Vec3* n, const Material& surface);

    bool intersect(const Ray& ray, Intersection& hit) const override;
    Bounds bounds() const override { return triangle.bounds(); }
};

}  // namespace sw
