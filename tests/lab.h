#pragma once

#include "swCamera.h"
#include "swScene.h"

// The functions that students write, as they stand in src/main.cpp.

sw::Color traceRay(const sw::Ray& ray, const sw::Scene& scene, int depth);

sw::Color samplePixel(float x, float y, int n, int depth, const sw::Camera& camera,
                      const sw::Scene& scene);
