#pragma once

#include "swCamera.h"
#include "swScene.h"

/// What stands in for each task until you have written it. So the program works from the first day
/// on, and draws what is there already.
///
/// Stuck in a task? `cmake -B build -DREFERENCE_TASKS="2;4"` makes the functions of tasks 2 and 4
/// answer as a right solution would, wherever your code still calls them (or calls them again).
namespace sw::todo {

/// Task 1. What the surface scatters of a light. Until then: white.
Color diffuse(const Intersection& hit, const Light& light);

/// Task 2. Until then: no triangle is ever hit.
bool intersect(const Triangle& triangle, const Ray& ray, Intersection& hit);

/// Task 3. Whether something stands between the hit point and a light. Until then: nothing does.
bool isInShadow(const Intersection& hit, const Light& light, const Scene& scene);

/// Task 4. What reflection adds to the colour, r * (reflected - scattered). Until then: nothing.
Color reflection(const Color& scattered, const Intersection& hit, const Scene& scene, int depth);

/// Task 4. Until then: a ray of no length.
Ray reflectedRay(const Intersection& hit);

/// Task 5. What refraction adds to the colour, t * (refracted - scattered). Until then: nothing.
Color refraction(const Color& scattered, const Intersection& hit, const Scene& scene, int depth);

/// Task 5. Until then: a ray of no length.
Ray refractedRay(const Intersection& hit);

/// Task 6. Until then: one ray through the pixel's centre.
Color samplePixel(float x, float y, int n, int depth, const Camera& camera, const Scene& scene);

}  // namespace sw::todo
