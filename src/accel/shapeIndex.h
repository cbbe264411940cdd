#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "swCone.h"
#include "swPatch.h"
#include "swSphere.h"
#include "swTriangle.h"

namespace sw {

/// The shapes of a scene. A few are scanned; many go into one tree.
///
/// Of several shapes hit at the same t, spheres come before triangles, cones, patches and foreign
/// primitives; among those of one type, the one pushed first counts.
class ShapeIndex {
public:
    ShapeIndex();
    ShapeIndex(const ShapeIndex& other);
    ShapeIndex& operator=(const ShapeIndex&) = delete;
    ~ShapeIndex();

    /// @tparam Shape  Sphere, Triangle, Cone, Patch or std::shared_ptr<Primitive>
    template <typename Shape>
    void push(Shape shape);

    /// Call this between the last push and the first search.
    void prepare(int threads);

    /// Spheres, triangles, cones, patches, foreign primitives.
    std::array<std::size_t, 5> sizes() const;
    bool hasTree() const;

    /// Finds what the ray hits with minT < t < maxT.
    /// @param ray  not part of `hit`
    /// @param hit  receives the nearest hit, or with `any` one of the hits
    bool find(const Ray& ray, Intersection& hit, bool any) const;
    /// Whether the ray hits anything with minT < t < maxT.
    bool isHit(const Ray& ray) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts;
};

}  // namespace sw
