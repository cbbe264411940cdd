#pragma once

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

/// A ray to that place whose origin is `away` from it, where t = 1.
inline sw::Ray rayTo(const sw::Triangle& t, const Barycentric& place, const sw::Vec3& away) {
    return {at(t, place) + away, -away};
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

/// The easiest of all triangles, and rays at a right angle to it.
inline sw::Triangle plainTriangle() {
    return triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
}
inline bool plainHit(const Barycentric& place, float height = 4) {
    return isHit(plainTriangle(), rayTo(plainTriangle(), place, {0, 0, height}));
}

/// Why a ray that should hit does not, as far as easy rays tell: a hint.
inline std::string whyMissed() {
    const bool front = plainHit({0.25f, 0.25f}), back = plainHit({0.25f, 0.25f}, -4);
    const bool behind = isHit(plainTriangle(), sw::Ray({1, 1, 4}, {0, 0, 1}));
    if (behind && !front)
        return "the sign of t is turned round: positive t lies ahead of the ray's origin";
    if (!front && !back) return "task 2 is not done yet: no ray ever hits a triangle";
    if (!front || !back)
        return "a triangle is hit from both sides: whether the ray runs with the normal or against "
               "it only decides about frontFacing";
    return "inside is where neither v nor w is negative and where their sum is at most 1";
}

/// Fails the test if no triangle is ever hit: else it might pass without any work done.
inline void requireHits() {
    if (plainHit({0.25f, 0.25f}) || plainHit({0.25f, 0.25f}, -4)) return;
    fail({"rays at a right angle to " + text(plainTriangle()) + ", from both sides to (1, 1, 0)",
          "no hit", "hits at t = 1", whyMissed()});
}

/// Triangles of several sizes and positions.
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
        {triangle({300, 0, -400}, {300, 900, -400}, {0, 0, 0}), {0.8f, 0, 0.6f}, {0, 1, 0}, 600},
        {triangle({0.001f, 0, 0}, {0.001f, 0.002f, 0}, {-0.001f, 0, 0}),
         {0, 0, 1},
         {1, 0, 0},
         0.002f},
    };
}

}  // namespace lab
