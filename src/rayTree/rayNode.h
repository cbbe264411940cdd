#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rayTree/rayProbe.h"

namespace rayTree {

/// A ray, what it hit, and the rays that were cast from there.
struct RayNode {
    Query query;           ///< the ray and its nearest hit
    bool asked = true;     ///< false: the function never intersected this ray with the scene
    bool isTraced = true;  ///< false: only an occlusion test, as for shadow rays
    int light = -1;        ///< if the ray is not traced: the light that it goes to; -1: none

    // For traced rays only:
    int depth = 0;                     ///< argument of traceRay()
    std::optional<sw::Color> color;    ///< result; none if the function did not return
    sw::Color weight{1, 1, 1};         ///< of that color in the parent's color, as measured
    std::vector<sw::Color> lightAdds;  ///< the part of the color that each light adds ...
    sw::Color otherAdds;               ///< ... and the part from neither light nor ray
    std::vector<RayNode> children;     ///< in the order in which they were cast
    bool isCut = false;                ///< its further rays were not followed

    std::vector<std::string> faults;  ///< faults that first appear here, not further down
};

}  // namespace rayTree
