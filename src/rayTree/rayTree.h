#pragma once

#include <cstddef>

#include "rayTree/rayNode.h"

namespace rayTree {

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
