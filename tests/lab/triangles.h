#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lab/teach.h"
#include "swTriangle.h"

/// What the tests of task 2 share. They call Triangle::intersect() itself, not through a scene.
namespace lab {

/// A place in a triangle's plane: w of the way along the side from the first vertex to the second,
/// and v along that to the third, as on the slides.
struct Barycentric {
    float w, v;
};

inline sw::Triangle triangle(const sw::Vec3& a, const sw::Vec3& b, const sw::Vec3& c) {
    const sw::Vec3 corners[] = {a, b, c};
    return {corners, sw::Material({0.25f, 0.5f, 0.75f}, 0.125f, 0.375f, 1.5f)};
}

inline sw::Vec3 at(const sw::Triangle& t, const Barycentric& place) {
    const sw::Vec3* corner = t.vertices;
    return corner[0] + place.w * (corner[1] - corner[0]) + place.v * (corner[2] - corner[0]);
}

inline sw::Vec3 side(const sw::Triangle& t, int vertex) {
    return t.vertices[vertex] - t.vertices[0];
}

/// As long as its parallelogram is large.
inline sw::Vec3 normalOf(const sw::Triangle& t) {
    return side(t, 1) % side(t, 2);
}

/// A ray to that place whose origin is `away` from it, where t = 1.
inline sw::Ray rayTo(const sw::Triangle& t, const Barycentric& place, const sw::Vec3& away) {
    return {at(t, place) + away, -away};
}

/// Component by component, to within `most`; never if one is NaN.
inline bool isNear(const sw::Vec3& a, const sw::Vec3& b, float most) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= most)) return false;
    return true;
}

inline bool isHit(const sw::Triangle& t, const sw::Ray& ray) {
    sw::Intersection ignored;
    return t.intersect(ray, ignored);
}

inline std::string text(const sw::Triangle& t) {
    return "the triangle " + text(t.vertices[0]) + " " + text(t.vertices[1]) + " " +
           text(t.vertices[2]);
}

inline std::string text(const sw::Ray& ray) {
    return "a ray from " + text(ray.orig) + " along " + text(ray.dir);
}

inline std::string text(const Barycentric& place) {
    return "v = " + text(place.v) + ", w = " + text(place.w);
}

/// The easiest of all triangles.
inline sw::Triangle plainTriangle() {
    return triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
}

/// A triangle of ordinary size: for very small and large ones there are tests of their own, so
/// that a fixed number that suits one size alone fails these.
struct TriangleCase {
    sw::Triangle shape;
    sw::Vec3 normal;  ///< unit, on the side that sees the vertices counter-clockwise
    sw::Vec3 across;  ///< unit, in the plane
    float size;       ///< of a side, roughly
};

inline std::vector<TriangleCase> triangleCases() {
    return {
        {plainTriangle(), {0, 0, 1}, {1, 0, 0}, 4},
        {triangle({2, -1, 3}, {2, 3, 3}, {2, -1, 7}), {1, 0, 0}, {0, 1, 0}, 4},
        {triangle({1, 2, 3}, {5, 2, 6}, {1, 7, 3}), {-0.6f, 0, 0.8f}, {0.8f, 0, 0.6f}, 5},
        {triangle({-2, 1, 0}, {1, 7, 6}, {4, 4, -6}),
         {-2 / 3.f, 2 / 3.f, -1 / 3.f},
         {1 / 3.f, 2 / 3.f, 2 / 3.f},
         9},
        // Acute, and obtuse.
        {triangle({3, 0, -4}, {3, 9, -4}, {0, 5, 0}), {0.8f, 0, 0.6f}, {0, 1, 0}, 7},
        {triangle({6, 2, 1}, {10, 3, 1}, {3, 4, 1}), {0, 0, 1}, {1, 0, 0}, 4},
    };
}

}  // namespace lab
