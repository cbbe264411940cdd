#pragma once

#include "rayTree/rayNode.h"

namespace rayTree {

/// Fills in RayNode::faults of a node and all below it: numbers that are NaN or infinite, negative
/// colours and a recursion that goes too deep, each only where it first appears. What comes from a
/// faulty ray further down is no fault of those above.
void markFaults(RayNode& primary);

}  // namespace rayTree
