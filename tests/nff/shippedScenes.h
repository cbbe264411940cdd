#pragma once

#include <vector>

#include "files.h"
#include "support.h"
#include "swNff.h"

namespace test {

using sw::Intersection;
using sw::Material;
using sw::Ray;
using sw::Scene;

/// Where the scenes are that are shipped.
inline const fs::path shippedFolder = SW_SCENES;

/// All of them, in any order.
inline std::vector<fs::path> shippedScenes() {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(shippedFolder))
        if (entry.path().extension() == ".nff") paths.push_back(entry.path());
    return paths;
}

/// What the ray from `from` towards `to` hits first.
inline Intersection seen(const Scene& scene, const Vec3& from, const Vec3& to) {
    Intersection hit;
    REQUIRE(scene.intersect(Ray(from, to - from), hit));
    return hit;
}

/// Colours within rounding, all else exactly.
inline void checkMaterial(const Material& m, const Color& color, float reflectivity,
                          float transparency, float index) {
    CHECK(distance(m.color, color) <= 2 * u);
    CHECK(m.reflectivity == reflectivity);
    CHECK(m.transparency == transparency);
    CHECK(m.refractiveIndex == index);
}

}  // namespace test
