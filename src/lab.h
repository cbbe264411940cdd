#pragma once

#include "swCamera.h"
#include "swScene.h"

// The functions that students write in main.cpp. The program renders with them, and the tests call
// them as they stand there.

/// The light that comes back along a ray.
/// @param depth  how many more times the ray may be reflected or refracted
sw::Color traceRay(const sw::Ray& ray, const sw::Scene& scene, int depth);

/// The colour of a pixel: the mean of n x n samples.
/// @param x, y  its top left corner
sw::Color samplePixel(float x, float y, int n, int depth, const sw::Camera& camera,
                      const sw::Scene& scene);
