#pragma once

#include <optional>

#include "rayTree/rayNode.h"

namespace rayTree {

/// A ray that a function cast from another ray's hit point.
struct Offspring {
    sw::Ray ray;
    sw::Color weight;  ///< approximate; 0 if the ray returns no color, not finite if unknown
};

/// Finds the next ray that is cast from a ray's hit point, ignoring rays further down. A child that
/// is made to miss casts no rays of its own: this tells children from grandchildren.
/// @param node  its ray, depth and children so far are known
std::optional<Offspring> nextChild(const RayNode& node, const Trace& trace, const sw::Scene& scene);

/// Measures the parts of a ray's color: the weights of its children, the color that each light
/// adds, and the rest.
/// @param node  its children are known
void measure(RayNode& node, const Trace& trace, const sw::Scene& scene);

/// The number of the light that a ray goes to, preferably one that no other ray goes to; -1: none.
int lightOf(const sw::Ray& ray, const std::vector<sw::Light>& lights,
            const std::vector<RayNode>& others);

}  // namespace rayTree
