#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "swNff.h"

namespace test {

/// Whether a message is one short line that says where, what was expected, and what was found.
inline bool isGoodMessage(const std::string& message) {
    int line = 0, column = 0, length = 0;
    return std::sscanf(message.c_str(), "a.nff:%d:%d: expected %n", &line, &column, &length) == 2 &&
           length > 0 && line >= 1 && column >= 1 && message.size() < 200 &&
           message.find(", found ") != std::string::npos && message.find('\n') == std::string::npos;
}

/// Whether a warning is one line that says where.
inline bool isGoodWarning(const std::string& warning) {
    int line = 0, column = 0, length = 0;
    return std::sscanf(warning.c_str(), "a.nff:%d:%d: warning: %n", &line, &column, &length) == 2 &&
           length > 0 && line >= 1 && column >= 1 && warning.size() < 200 &&
           warning.find('\n') == std::string::npos;
}

/// Whether a ray through the scene, and what it spawns, are as they should be: no NaN, and unit
/// normals against the ray.
inline bool isTracedWell(const sw::Scene& scene, const sw::Ray& ray, int depth = 2) {
    sw::Intersection hit;
    if (!scene.intersect(ray, hit)) return true;
    const bool isOnRay = hit.hitT > ray.minT && hit.hitT < ray.maxT;
    const bool isUnit = std::fabs(hit.normal * hit.normal - 1) < 1e-5f;
    if (!isOnRay || !isUnit || hit.normal * ray.dir > 1e-5f) return false;
    for (const sw::Light& light : scene.lights()) {
        sw::Intersection blocker;
        scene.intersect(hit.getShadowRay(light.position), blocker, true);
    }
    return depth == 0 || (isTracedWell(scene, hit.getReflectedRay(), depth - 1) &&
                          isTracedWell(scene, hit.getRefractedRay(), depth - 1));
}

/// Whether a scene file is rendered, or refused with a position and one line. Anything else is a
/// bug.
inline bool isHandled(std::string_view text) {
    try {
        const sw::NffScene file = sw::parseNff(text, "a.nff");
        bool good = file.width >= 1 && file.height >= 1 && file.warnings.size() <= 10;
        for (const std::string& warning : file.warnings) good = good && isGoodWarning(warning);
        const auto width = static_cast<float>(file.width), height = static_cast<float>(file.height);
        for (const float y : {0.0f, 0.3f, 0.5f})
            for (const float x : {0.2f, 0.5f, 1.0f})
                good = good && isTracedWell(file.scene, file.camera.getRay(x * width, y * height));
        return good;
    } catch (const sw::NffError& error) {
        return isGoodMessage(error.what());
    }
}

}  // namespace test
