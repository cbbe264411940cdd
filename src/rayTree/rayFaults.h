#pragma once

#include "rayTree/rayNode.h"

namespace rayTree {

/// Fills in RayNode::faults of a node and of all nodes below it: numbers that are NaN or infinite,
/// negative colours, and a recursion that goes too deep. Each is reported only where it first
/// appears: a ray is not blamed for a faulty ray below it.
void markFaults(RayNode& primary);

}  // namespace rayTree
