#pragma once

#include <optional>

#include "rayTree/rayNode.h"

namespace rayTree {

/// A ray that a function cast from where another ray hit.
struct Offspring {
    sw::Ray ray;
    sw::Color weight;  ///< roughly; 0 for rays that bring back no color, not finite if unknown
};

/// Finds the next ray that is cast from where a ray hits, not further down. A ray that is told that
/// it hits nothing casts no further ones: that is how to tell children from grandchildren.
/// @param node  whose ray, depth and children so far are known
std::optional<Offspring> nextChild(const RayNode& node, const Trace& trace, const sw::Scene& scene);

/// Measures what adds up to a ray's color: the weights of its children, what each light adds, and
/// what comes from elsewhere.
/// @param node  whose children are known
void measure(RayNode& node, const Trace& trace, const sw::Scene& scene);

/// The number of the light that a ray goes to, preferably not one that others go to; -1: none.
int lightOf(const sw::Ray& ray, const std::vector<sw::Light>& lights,
            const std::vector<RayNode>& others);

}  // namespace rayTree
