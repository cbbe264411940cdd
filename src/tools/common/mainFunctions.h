#pragma once

#include "swCamera.h"
#include "swScene.h"

/// The functions of src/main.cpp as they stand there, for tests and tools that call them.
namespace lab {

/// Which of these functions this thread is in: "traceRay()"; null: in none.
inline thread_local constinit const char* studentFunction = nullptr;

sw::Color traceRay(const sw::Ray& ray, const sw::Scene& scene, int depth);
sw::Color samplePixel(float x, float y, int n, int depth, const sw::Camera& camera,
                      const sw::Scene& scene);

}  // namespace lab
