#pragma once

#include <cstddef>

#include "rayTree/rayNode.h"

namespace rayTree {

/// The rays behind a point of the picture.
struct RayTree {
    RayNode primary;
    std::size_t cast = 0;    ///< rays that the function cast until it returned or was stopped
    std::size_t nodes = 0;   ///< how many of them are in the tree
    bool ends = true;        ///< false: the function was stopped after mostRays
    bool isFaithful = true;  ///< whether the tree holds just the rays that the function cast
};

/// Finds the rays behind a ray by calling a function again and again. It measures the color of each
/// ray, its weight and the light added there: it makes other rays miss and compares the results. If
/// the function does not end, only its first rays are followed.
/// @param trace   must do the same for the same arguments, and return weighted sums of colors
/// @param stage   of the scene; one may serve for many rays
/// @param lights  false: leave out RayNode::lightAdds, which takes a call for every light
RayTree growTree(const Trace& trace, const sw::Ray& primary, Stage& stage, int depth,
                 bool lights = true);
inline RayTree growTree(const Trace& trace, const sw::Ray& primary, const sw::Scene& scene,
                        int depth) {
    Stage stage(scene);
    return growTree(trace, primary, stage, depth);
}

}  // namespace rayTree
