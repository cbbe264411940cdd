#pragma once

// How the shapes of a block lie in memory. Memory decides how fast a large scene is. So only the
// coordinates of a shape are kept, and within a block the x of all shapes come first, then the y,
// and so on: a filter reads each row as one vector.

#include <cstddef>
#include <cstdint>

#include "accel/filterKernels.h"
#include "swCone.h"
#include "swPatch.h"
#include "swSphere.h"
#include "swTriangle.h"

namespace sw {
namespace {

/// One shape in the rows of its block: its k-th number is number k * stride.
template <typename Float>
struct Column {
    Float* first;
    std::size_t stride;

    Float& operator[](std::size_t k) const { return first[k * stride]; }
    Vec3 point(std::size_t k) const { return {(*this)[k], (*this)[k + 1], (*this)[k + 2]}; }
    void setPoint(std::size_t k, const Vec3& p) const {
        for (int i = 0; i < 3; ++i) (*this)[k + static_cast<std::size_t>(i)] = p[i];
    }
};

/// The rows of a type of shape.
template <typename Shape>
struct Rows;

/// Centre, radius.
template <>
struct Rows<Sphere> {
    static constexpr std::size_t count = 4;

    static void write(const Sphere& sphere, Column<float> to) {
        to.setPoint(0, sphere.center);
        to[3] = sphere.radius;
    }
    static void read(Column<const float> from, Sphere& sphere) {
        sphere.center = from.point(0);
        sphere.radius = from[3];
    }
    SW_INLINE static SphereFilter filter(const FilterRay& ray, const float* row,
                                         std::size_t stride) {
        return {ray, spread(ray.orig) - loadRows(row, stride), load(row + 3 * stride)};
    }
};

/// Three vertices, the edges' longest component.
template <>
struct Rows<Triangle> {
    static constexpr std::size_t count = 10;

    static void write(const Triangle& triangle, Column<float> to) {
        const auto& v = triangle.vertices;
        for (std::size_t i = 0; i < 3; ++i) to.setPoint(3 * i, v[i]);
        to[9] = longestComponent(v[1] - v[0], v[2] - v[0]);
    }
    static void read(Column<const float> from, Triangle& triangle) {
        for (std::size_t i = 0; i < 3; ++i) triangle.vertices[i] = from.point(3 * i);
    }
    SW_INLINE static TriangleFilter filter(const FilterRay& ray, const float* row,
                                           std::size_t stride) {
        const Float3 v0 = loadRows(row, stride);
        const Float3 e1 = loadRows(row + 3 * stride, stride) - v0;
        const Float3 e2 = loadRows(row + 6 * stride, stride) - v0;
        return {ray, v0, e1, e2, load(row + 9 * stride)};
    }
};

/// As a triangle, then the normals at the vertices.
template <>
struct Rows<Patch> {
    static constexpr std::size_t normals = 10, count = 19;

    static void write(const Patch& patch, Column<float> to) {
        Rows<Triangle>::write(patch.triangle, to);
        for (std::size_t i = 0; i < 3; ++i) to.setPoint(normals + 3 * i, patch.normals[i]);
    }
    static void read(Column<const float> from, Patch& patch) {
        Rows<Triangle>::read(from, patch.triangle);
        for (std::size_t i = 0; i < 3; ++i) patch.normals[i] = from.point(normals + 3 * i);
    }
    SW_INLINE static TriangleFilter filter(const FilterRay& ray, const float* row,
                                           std::size_t stride) {
        return Rows<Triangle>::filter(ray, row, stride);
    }
};

/// Base and its radius, apex and its radius, the cylinder around.
template <>
struct Rows<Cone> {
    static constexpr std::size_t cylinder = 8, count = 16;

    static void write(const Cone& cone, Column<float> to) {
        to.setPoint(0, cone.base);
        to[3] = cone.baseRadius;
        to.setPoint(4, cone.apex);
        to[7] = cone.apexRadius;
        const CylinderAround around(cone);
        to.setPoint(cylinder, around.center);
        to.setPoint(cylinder + 3, around.axis);
        to[cylinder + 6] = around.radius;
        to[cylinder + 7] = around.reach;
    }
    static void read(Column<const float> from, Cone& cone) {
        cone.base = from.point(0);
        cone.baseRadius = from[3];
        cone.apex = from.point(4);
        cone.apexRadius = from[7];
    }
    SW_INLINE static ConeFilter filter(const FilterRay& ray, const float* row, std::size_t stride) {
        const float* first = row + cylinder * stride;
        return {ray, spread(ray.orig) - loadRows(first, stride),
                loadRows(first + 3 * stride, stride), load(first + 6 * stride),
                load(first + 7 * stride)};
    }
};

}  // namespace
}  // namespace sw
