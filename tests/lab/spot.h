#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "lab/matte.h"
#include "tools/common/mainFunctions.h"

/// What the tests of task 1 look at, so that it shows whatever the other tasks' code does.
namespace lab {

/// How a surface is shown. Mostly as it is; but where a mistake in another task blackens all of
/// that, in a way that such a mistake brings to light.
enum class Showing {
    plain,    ///< nothing hides the lights
    covered,  ///< everything hides them: task 3 may have light and shadow exchanged
    mirror    ///< of reflectivity 1: task 4 may have the weights exchanged
};

/// Stands in the way of every ray but the eye's.
class Cover : public sw::Primitive {
public:
    explicit Cover(const sw::Vec3& eye) : Primitive(matte({0, 0, 0})), eye(eye) {}

    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        if ((ray.orig - eye).isZero()) rays = 0;
        // So that a recursion that knows no end finds one: nothing is hit any more.
        if (rays == most || rays++ == 0) return false;
        hit.hitT = ray.minT + 0.1f * (std::min(ray.maxT, 1.f) - ray.minT);
        hit.position = ray.orig + hit.hitT * ray.dir;
        hit.normal = -ray.dir;
        hit.normal.normalize();
        hit.frontFacing = true;
        hit.material = material;
        hit.ray = ray;
        return true;
    }

private:
    static constexpr int most = 100;
    sw::Vec3 eye;
    mutable int rays = 0;
};

inline sw::Material shownPaint(const sw::Color& color, Showing showing) {
    sw::Material material = matte(color);
    if (showing == Showing::mirror) material.reflectivity = 1;
    return material;
}

inline void coverIfNeeded(sw::Scene& scene, const sw::Vec3& eye, Showing showing) {
    if (showing == Showing::covered) scene.push(std::make_shared<Cover>(eye));
}

/// A bit of surface that faces +z, with lights and an eye. Places are counted from the surface.
struct Spot {
    std::vector<sw::Light> lights;
    sw::Color color{0.5f, 0.25f, 0.75f};
    sw::Vec3 where{-3, 8, 1};
    sw::Vec3 eye{-5, 0, 12};  ///< 13 long: cosine 12/13
};

/// The surface itself. It is seen from the eye, and no other ray can meet it.
class SpotSurface : public sw::Primitive {
public:
    SpotSurface(const Spot& spot, const sw::Material& material)
        : Primitive(material), position(spot.where), eye(spot.where + spot.eye) {}

    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        if (!(ray.orig - eye).isZero()) return false;
        hit.hitT = (position - eye).norm();
        hit.position = position;
        hit.normal = sw::Vec3(0, 0, 1);
        hit.frontFacing = true;
        hit.material = material;
        hit.ray = ray;
        return ray.contains(hit.hitT);
    }

private:
    sw::Vec3 position, eye;
};

// Not 0: what traceRay() does at the end of the recursion is task 4.
constexpr int usualDepth = 3;

/// What the student's traceRay() makes of a spot.
inline sw::Color colorOf(const Spot& spot, Showing showing) {
    sw::Scene scene;
    coverIfNeeded(scene, spot.where + spot.eye, showing);
    scene.push(std::make_shared<SpotSurface>(spot, shownPaint(spot.color, showing)));
    for (const sw::Light& light : spot.lights)
        scene.push(sw::Light(spot.where + light.position, light.color));
    sw::Vec3 along = -spot.eye;
    return traceRay(sw::Ray(spot.where + spot.eye, along.normalize()), scene, usualDepth);
}

/// The first way in which any light at all makes a difference; else the plain one.
inline Showing bestShowing() {
    for (const Showing showing : {Showing::plain, Showing::covered, Showing::mirror})
        for (const sw::Vec3& light : {sw::Vec3(3, 0, 4), sw::Vec3(0, 0, 2), sw::Vec3(-4, 1, -3)})
            if (!colorOf({{sw::Light(light)}}, showing).isZero()) return showing;
    return Showing::plain;
}

inline sw::Color colorOf(const Spot& spot) {
    static const Showing showing = bestShowing();
    return colorOf(spot, showing);
}

}  // namespace lab
