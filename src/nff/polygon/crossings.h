#pragma once

#include <vector>

#include "nff/polygon/orientation.h"

namespace sw {

/// Whether any two sides of a polygon cross in a point that is an end of neither. Sides that touch
/// or coincide do not cross. Takes n log n steps (Shamos and Hoey, Geometric Intersection
/// Problems, 1976).
bool hasCrossings(const std::vector<Point2>& polygon);

}  // namespace sw
