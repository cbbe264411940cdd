#pragma once

#include "stability/cases.h"

namespace test {

using sw::Ray;
using sw::Triangle;

/// A triangle and a ray that is hard on it.
struct TriangleCase {
    Triangle triangle;
    Ray ray;
};

/// Of any size from 1e-6 to 1e6 or 1e+-18, and at up to 1e6 times that distance from the origin;
/// one in four is a sliver, up to 1e7 times as long as wide. Rounding may leave no area at all.
inline Triangle randomTriangle(Random& random) {
    const int kind = random.whole(0, 19);
    const double size = kind == 0 ? 1e18 : kind == 1 ? 1e-18 : random.magnitude(1e-6, 1e6);
    const double aspect = random.whole(0, 3) == 0 ? random.magnitude(1, 1e7) : 1;
    const Vec3 middle = random.direction() *
                        static_cast<float>(random.coin() ? size * random.magnitude(0.1, 1e6) : 0);
    const Vec3 along = anyDirection(random), side = across(random, along);
    const Vec3 far = moved(middle, along, size), beside = moved(middle, side, size / aspect);
    const Vec3 v[] = {middle, random.coin() ? far : moved(far, along, -0.5 * size),
                      random.coin() ? beside : moved(beside, along, random.uniform(0, size))};
    const int first = random.whole(0, 2);  // any corner may be the sharp one
    const Vec3 turned[] = {v[first], v[(first + 1) % 3], v[(first + 2) % 3]};
    return Triangle(turned, sw::Material());
}

/// A point in the triangle's plane: within it, on its edges, at its corners or around it.
inline Vec3 pointAt(Random& random, const Triangle& triangle) {
    double a = random.uniform(-0.2, 1.2), b = random.uniform(-0.2, 1.2 - std::fmax(a, 0));
    const int kind = random.whole(0, 5);
    if (kind == 0) a = 0;                      // on an edge
    if (kind == 1) a = random.coin() ? 0 : 1;  // at a corner
    if (kind == 1) b = 0;
    const dvec3 v0 = toDouble(triangle.vertices[0]);
    return sw::num::toFloat(v0 + a * (toDouble(triangle.vertices[1]) - v0) +
                            b * (toDouble(triangle.vertices[2]) - v0));
}

inline TriangleCase randomTriangleCase(Random& random) {
    TriangleCase c{randomTriangle(random), {}};
    const Vec3 target = pointAt(random, c.triangle);
    const Vec3* v = c.triangle.vertices;
    const double size = (v[1] - v[0]).norm() + (v[2] - v[0]).norm();
    const Vec3 away = random.whole(0, 5) == 0 ? (v[1] - target).normalize()  // nearly edge-on
                                              : anyDirection(random);
    const double distance = size * random.magnitude(1e-3, 1e6);
    const Vec3 from = random.whole(0, 9) == 0 ? target : moved(target, away, distance);
    c.ray = rayThrough(random, from, target);
    if (random.whole(0, 9) == 0) c.ray.dir = -c.ray.dir;
    if (random.coin())
        for (float& x : c.ray.dir.m)
            if (x == 0) x = random.coin() ? 0.0f : -0.0f;
    return c;
}

}  // namespace test
