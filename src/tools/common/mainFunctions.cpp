#include "tools/common/mainFunctions.h"

#define main swtracerMain
#include "main.cpp"
#undef main

sw::Color lab::traceRay(const sw::Ray& ray, const sw::Scene& scene, int depth) {
    return ::traceRay(ray, scene, depth);
}

sw::Color lab::samplePixel(float x, float y, int n, int depth, const sw::Camera& camera,
                           const sw::Scene& scene) {
    return ::samplePixel(x, y, n, depth, camera, scene);
}
