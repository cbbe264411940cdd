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

/// The rays behind a point of the picture.
struct RayTree {
    RayNode primary;
    std::size_t cast = 0;    ///< how many rays the function cast until it came back or was stopped
    std::size_t nodes = 0;   ///< how many of them are in the tree
    bool ends = true;        ///< false: the function was stopped after mostRays
    bool isFaithful = true;  ///< whether the tree holds just the rays that the function cast
};

/// Finds the rays behind a ray by calling a function again and again. The color of every ray, its
/// weight and what the lights add are measured by what comes back if other rays are made to hit
/// nothing. Of a function that does not end only the first rays are followed.
/// @param trace  must do the same whenever it is called with the same arguments, and compute colors
///               that are sums of weighted colors
RayTree growTree(const Trace& trace, const sw::Ray& primary, const sw::Scene& scene, int depth);

}  // namespace rayTree
