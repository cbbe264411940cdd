#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rayTree/rayProbe.h"

namespace rayTree {

/// A ray, what it hit, and the rays that were cast from there.
struct RayNode {
    Query query;           ///< the ray and its nearest hit
    bool asked = true;     ///< false: the function never asked what this ray hits
    bool isTraced = true;  ///< false: only asked whether something is in the way, as for a shadow
    int light = -1;  ///< of a ray that is not traced: number of the light it goes to; -1: none

    // Of traced rays only:
    int depth = 0;                     ///< what traceRay() was called with
    std::optional<sw::Color> color;    ///< what came back; none where it did not come to an end
    sw::Color weight{1, 1, 1};         ///< of that color in the parent's, as measured
    std::vector<sw::Color> lightAdds;  ///< what each light of the scene adds to the color ...
    sw::Color otherAdds;               ///< ... and what comes from neither light nor ray
    std::vector<RayNode> children;     ///< in the order in which they were cast
    bool isCut = false;                ///< rays from here on were not followed

    std::vector<std::string> faults;  ///< what is wrong here first: not further down
};

}  // namespace rayTree
