#pragma once

#include <memory>
#include <typeinfo>
#include <vector>

#include "stability/cases.h"
#include "swScene.h"

namespace test {

using Shapes = std::vector<std::shared_ptr<sw::Primitive>>;

/// A student's primitive: a sphere that does not tell its bounds.
class BoundlessSphere : public sw::Sphere {
public:
    using Sphere::Sphere;
    sw::Bounds bounds() const override { return Primitive::bounds(); }
};

inline sw::Material anyMaterial(Random& random) {
    const float mirrored = random.real(0, 0.6), refracted = random.real(0, 0.4);
    return sw::Material({random.real(0, 1), random.real(0, 1), random.real(0, 1)}, mirrored,
                        refracted, random.real(0.5, 2));
}

inline sw::Sphere anySphere(Random& random) {
    return sw::Sphere(random.point(10), random.magnitude(0.01, 5), anyMaterial(random));
}

/// A triangle; one in three lies flat in a plane y = constant, as floors do.
inline sw::Triangle anyTriangle(Random& random) {
    const double size = random.magnitude(0.01, 10);
    const Vec3 at = random.point(10);
    Vec3 v[] = {at, at + random.point(size), at + random.point(size)};
    if (random.whole(0, 2) == 0) v[1][1] = v[2][1] = v[0][1];
    return sw::Triangle(v, anyMaterial(random));
}

/// The triangle that makes a parallelogram with another one, as nearly as floats can.
inline sw::Triangle otherHalf(const sw::Triangle& triangle) {
    const auto& v = triangle.vertices;
    const Vec3 half[] = {v[1], v[1] + (v[2] - v[0]), v[2]};
    return sw::Triangle(half, triangle.material);
}

/// Adds a primitive to a scene, by value where the scene has a type for it, and to a list.
inline void add(sw::Scene& scene, Shapes& shapes, const std::shared_ptr<sw::Primitive>& shape) {
    shapes.push_back(shape);
    const sw::Primitive& object = *shape;
    if (typeid(object) == typeid(sw::Sphere))
        scene.push(static_cast<const sw::Sphere&>(object));
    else if (typeid(object) == typeid(sw::Triangle))
        scene.push(static_cast<const sw::Triangle&>(object));
    else if (typeid(object) == typeid(sw::Cone))
        scene.push(static_cast<const sw::Cone&>(object));
    else if (typeid(object) == typeid(sw::Patch))
        scene.push(static_cast<const sw::Patch&>(object));
    else
        scene.push(shape);
}

}  // namespace test
