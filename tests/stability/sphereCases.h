#pragma once

#include "stability/cases.h"

namespace test {

using sw::Ray;
using sw::Sphere;

/// A sphere and a ray that is hard on it.
struct SphereCase {
    Sphere sphere;
    Ray ray;
};

inline Sphere randomSphere(Random& random) {
    const int kind = random.whole(0, 9);
    const float radius = kind == 0 ? 1e18f : kind == 1 ? 1e-18f : random.magnitude(1e-6, 1e6);
    Sphere sphere({0, 0, 0}, radius, sw::Material());
    if (random.coin()) sphere.center = random.direction() * (radius * random.magnitude(0.1, 1e3));
    return sphere;
}

/// A ray from anywhere at a point of the sphere's disc, or beside it.
inline Ray fromAfar(Random& random, const Sphere& sphere) {
    const Vec3 away = anyDirection(random), side = across(random, away);
    const double beside = random.uniform(0, 1.2) * sphere.radius;
    const Vec3 target = moved(sphere.center, side, beside);
    const double distance = random.magnitude(1, 1e7) * static_cast<double>(sphere.radius);
    return rayThrough(random, moved(target, away, distance), target);
}

/// A ray that touches the sphere, to all digits that float has.
inline Ray tangent(Random& random, const Sphere& sphere) {
    const Vec3 along = anyDirection(random), side = across(random, along);
    const double miss = random.coin() ? random.magnitude(1e-16, 1e-3) : 0;
    const double lever = sphere.radius * (1 + (random.coin() ? miss : -miss));
    const Vec3 target = moved(sphere.center, side, lever);
    const double distance = random.magnitude(0.1, 1e4) * static_cast<double>(sphere.radius);
    return rayThrough(random, moved(target, along, distance), target);
}

/// A ray parallel to an axis that touches a sphere around 0 in exact arithmetic.
inline Ray axisTangent(Random& random, float radius) {
    const int axis = random.whole(0, 2);
    Ray ray({0, 0, 0}, {random.coin() ? 0.0f : -0.0f, random.coin() ? 0.0f : -0.0f, 0});
    if (axis != 2) ray.dir[2] = random.coin() ? 0.0f : -0.0f;
    ray.dir[axis] = random.coin() ? 1.0f : -1.0f;
    ray.orig[axis] = -ray.dir[axis] * radius * random.magnitude(1, 1e5);
    ray.orig[(axis + 1) % 3] = random.coin() ? radius : -radius;
    return ray;
}

/// A ray from inside the sphere, from its surface, or from its very centre.
inline Ray fromWithin(Random& random, const Sphere& sphere) {
    const int kind = random.whole(0, 2);
    const double part = kind == 0 ? 0 : kind == 1 ? 1 : random.magnitude(1e-6, 1);
    const Vec3 from = moved(sphere.center, random.direction(), part * sphere.radius);
    return rayThrough(random, from, moved(from, anyDirection(random), sphere.radius));
}

inline SphereCase randomSphereCase(Random& random) {
    SphereCase c{randomSphere(random), {}};
    switch (random.whole(0, 5)) {
        case 0:
            c.ray = tangent(random, c.sphere);
            break;
        case 1:
            c.sphere.center = Vec3();
            c.ray = axisTangent(random, c.sphere.radius);
            break;
        case 2:
            c.ray = fromWithin(random, c.sphere);
            break;
        default:
            c.ray = fromAfar(random, c.sphere);
    }
    return c;
}

}  // namespace test
