#pragma once

#include <algorithm>

#include "support.h"
#include "swScene.h"

namespace test {

/// traceRay() by the book, as students write it, with ways and mistakes to choose from. A scene is
/// a sw::Scene, or what has its intersect(), lights() and background().
struct Student {
    bool ownRays = false;        ///< makes all rays by hand, as on slides
    bool copiesScene = false;    ///< takes it by value
    bool decreasesDepth = true;  ///< on the way down
    bool testsDepth = true;      ///< traces nothing further at depth 0
    bool testsWeight = true;     ///< traces no ray of weight 0
    bool testsShadow = true;     ///< casts a ray to every light
    bool blackInShadow = false;  ///< returns at once where a light is hidden
    bool indexAsWeight = false;  ///< takes the refractive index for the transparency
    bool clampsCosine = true;    ///< at 0

    template <typename Scene>
    Color operator()(const sw::Ray& ray, const Scene& scene, int depth) const {
        if (!copiesScene) return trace(ray, scene, depth);
        const Scene copy = scene;
        return trace(ray, copy, depth);
    }

private:
    template <typename Scene>
    Color trace(const sw::Ray& ray, const Scene& scene, int depth) const {
        sw::Intersection hit;
        if (!scene.intersect(ray, hit)) return scene.background();
        Color scattered(0, 0, 0);
        for (const sw::Light& light : scene.lights()) {
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

    template <typename Scene>
    bool isInShadow(const sw::Intersection& hit, const sw::Light& light, const Scene& scene) const {
        sw::Intersection blocker;
        const Vec3 way = light.position - hit.position;
        const sw::Ray own(hit.position, way, 0.001f, 1);
        return scene.intersect(ownRays ? own : hit.getShadowRay(light.position), blocker, true);
    }

    template <typename Scene>
    Color bounce(float part, float weight, sw::Ray ray, const Scene& scene, int depth) const {
        if ((testsDepth && depth <= 0) || (testsWeight && !(part > 0))) return Color(0, 0, 0);
        if (ownRays) ray = sw::Ray(ray.orig, ray.dir, 0.01f);
        return weight * (*this)(ray, scene, decreasesDepth ? depth - 1 : depth);
    }
};

}  // namespace test
