#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "lab/matte.h"
#include "lab/teach.h"
#include "tools/common/mainFunctions.h"

/// What the tests of task 3 share.
namespace lab {

/// The plane z = 0, hit from both sides.
class Floor : public sw::Primitive {
public:
    Floor() : Primitive(matte({0.75f, 0.75f, 0.75f})) {}
    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        const float t = -ray.orig[2] / ray.dir[2];
        if (!(ray.minT < t && t < ray.maxT)) return false;
        hit.hitT = t;
        hit.position = ray.orig + t * ray.dir;
        hit.position[2] = 0;
        hit.frontFacing = ray.dir[2] < 0;
        hit.normal = sw::Vec3(0, 0, hit.frontFacing ? 1.f : -1.f);
        hit.material = material;
        hit.ray = ray;
        return true;
    }
};

inline sw::Scene floorUnder(const std::vector<sw::Light>& lights) {
    sw::Scene scene;
    scene.push(std::make_shared<Floor>());
    for (const sw::Light& light : lights) scene.push(light);
    return scene;
}

/// The colour of a point of the scene, seen from (-4, 0, 3) away.
inline sw::Color lookAt(const sw::Scene& scene, const sw::Vec3& point, int depth) {
    return traceRay(sw::Ray(point + sw::Vec3(-4, 0, 3), sw::Vec3(0.8f, 0, -0.6f)), scene, depth);
}

inline bool isBlack(const sw::Color& color) {
    return color.isZero();
}

/// As far as it matters here: no test depends on rounding.
inline bool same(const sw::Color& a, const sw::Color& b) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= 1e-5f * (1 + std::fabs(b[i])))) return false;
    return true;
}

/// A small ball.
inline sw::Sphere thing(const sw::Vec3& centre) {
    return {centre, 0.5f, matte({1, 1, 1})};
}

/// Fails the test unless at least one of several balls between floor and light makes a difference:
/// else it might pass without any work done.
inline void requireAnyShadow() {
    sw::Scene scene = floorUnder({sw::Light({0, 0, 6})});
    const sw::Color lit = lookAt(scene, {0, 0, 0}, 0);
    for (const float height : {3.f, 0.75f, 5.f}) {
        sw::Scene hidden = scene;
        hidden.push(thing({0, 0, height}));
        if (!same(lookAt(hidden, {0, 0, 0}, 0), lit)) return;
    }
    fail({"the floor's point (0, 0, 0) under a light at (0, 0, 6), with balls in between",
          "the colour " + text(lit) + ", as without them", "black",
          "task 3 is not done yet: nothing asks whether something stands between surface and "
          "light"});
}

}  // namespace lab
