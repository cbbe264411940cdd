#pragma once

#include "rayTree/rayNode.h"

namespace rayTree {

/// Whether a function's color depends on what the next ray after the node's children brings back:
/// then it traced that ray. A shadow ray only lets light in.
/// @param node  its ray, depth and children so far are known
bool dependsOnNext(const RayNode& node, const Trace& trace, Stage& stage);

/// Measures the parts of a ray's color: the weights of its children, the color that each light
/// adds, and the rest.
/// @param node    its children are known
/// @param lights  false: leave out the lights
void measure(RayNode& node, const Trace& trace, Stage& stage, bool lights);

/// The number of the light that a ray goes to, preferably one that no other ray goes to; -1: none.
int lightOf(const sw::Ray& ray, const std::vector<sw::Light>& lights,
            const std::vector<RayNode>& others);

}  // namespace rayTree
