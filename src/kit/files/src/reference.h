#pragma once

#include "swCamera.h"
#include "swScene.h"

/// The right solution of every task, as compiled code: see todo.h.
namespace sw::reference {

/// Whether CMake was asked for the reference of a task.
constexpr bool answersFor(int task) {
    for (const int asked : {0 SW_REFERENCE_TASKS})
        if (asked == task) return true;
    return false;
}

Color diffuse(const Intersection& hit, const Light& light);
bool intersect(const Triangle& triangle, const Ray& ray, Intersection& hit);
bool isInShadow(const Intersection& hit, const Light& light, const Scene& scene);
Color reflection(const Color& scattered, const Intersection& hit, const Scene& scene, int depth);
Ray reflectedRay(const Intersection& hit);
Color refraction(const Color& scattered, const Intersection& hit, const Scene& scene, int depth);
Ray refractedRay(const Intersection& hit);
Color samplePixel(float x, float y, int n, int depth, const Camera& camera, const Scene& scene);

}  // namespace sw::reference
