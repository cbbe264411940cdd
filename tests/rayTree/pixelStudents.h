#pragma once

#include <algorithm>
#include <cmath>

#include "rayTree/rayTree.h"
#include "support.h"

// traceRay() as students write it, and what may go wrong there.

namespace test {

using sw::Intersection;
using sw::Light;
using sw::Material;
using sw::Ray;
using sw::Scene;
using sw::Sphere;

/// A solution by the book, with mistakes to choose from.
struct Student {
    bool ownRays = false;        ///< makes all rays by hand, as on slides
    bool decreasesDepth = true;  ///<
    bool testsDepth = true;      ///<
    bool testsWeight = true;     ///<
    bool testsShadow = true;     ///<
    bool blackInShadow = false;  ///< returns at once where a light is hidden
    bool indexAsWeight = false;  ///< takes the refractive index for the transparency
    bool clampsCosine = true;    ///<
    bool copiesScene = false;    ///< takes it by value

    Color operator()(const Ray& ray, const Scene& scene, int depth) const {
        if (!copiesScene) return trace(ray, scene, depth);
        const Scene copy = scene;
        return trace(ray, copy, depth);
    }

private:
    Color trace(const Ray& ray, const Scene& scene, int depth) const {
        Intersection hit;
        if (!scene.intersect(ray, hit)) return scene.background();
        Color scattered(0, 0, 0);
        for (const Light& light : scene.lights()) {
            if (testsShadow && isInShadow(hit, light, scene)) {
                if (blackInShadow) return Color(0, 0, 0);
                continue;
            }
            const float cosine = hit.normal * (light.position - hit.position).normalize();
            scattered += (clampsCosine ? std::max(0.f, cosine) : cosine) *
                         hit.material.color.times(light.color);
        }
        const float r = hit.material.reflectivity, t = hit.material.transparency;
        Color color = (1 - r - t) * scattered;
        color += bounce(r, r, hit.getReflectedRay(), scene, depth);
        const float weight = indexAsWeight ? hit.material.refractiveIndex : t;
        return color + bounce(t, weight, hit.getRefractedRay(), scene, depth);
    }

    bool isInShadow(const Intersection& hit, const Light& light, const Scene& scene) const {
        Intersection blocker;
        const Vec3 way = light.position - hit.position;
        const Ray own(hit.position, way, 0.001f, 1);
        return scene.intersect(ownRays ? own : hit.getShadowRay(light.position), blocker, true);
    }

    Color bounce(float part, float weight, Ray ray, const Scene& scene, int depth) const {
        if ((testsDepth && depth <= 0) || (testsWeight && !(part > 0))) return Color(0, 0, 0);
        if (ownRays) ray = Ray(ray.orig, ray.dir, 0.01f);
        return weight * (*this)(ray, scene, decreasesDepth ? depth - 1 : depth);
    }
};

inline Material randomMaterial(Random& random) {
    const Color color(random.real(0.1, 1), random.real(0.1, 1), random.real(0.1, 1));
    const float r = random.coin() ? random.real(0.05, 0.5) : 0.f;
    const float t = random.coin() ? random.real(0.05, 0.5) : 0.f;
    return Material(color, r, t, random.real(1, 2));
}

/// Some spheres around the origin, some lights and a sky.
inline Scene randomRoom(Random& random) {
    Scene scene;
    for (int i = random.whole(2, 12); i > 0; --i)
        scene.push(Sphere(random.point(6), random.real(0.5, 4), randomMaterial(random)));
    for (int i = random.whole(0, 4); i > 0; --i)
        scene.push(Light(random.point(20), Color(random.real(0.1, 1), random.real(0.1, 1), 1)));
    scene.setBackground(Color(0.25f, random.real(0, 1), 0.75f));
    return scene;
}

/// From outside into the middle.
inline Ray randomLook(Random& random) {
    const Vec3 eye = 30 * random.direction();
    return Ray(eye, (random.point(3) - eye).normalize(), 0, FLT_MAX, sw::RayKind::primary);
}

/// Calls visit(node, parent) for every node, parents first; the first has none.
template <typename Visit>
void visitAll(const rayTree::RayNode& node, const Visit& visit,
              const rayTree::RayNode* parent = nullptr) {
    visit(node, parent);
    for (const rayTree::RayNode& child : node.children) visitAll(child, visit, &node);
}

}  // namespace test
