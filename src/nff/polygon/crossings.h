#pragma once

#include <vector>

#include "nff/polygon/orientation.h"

namespace sw {

/// Whether any two sides of a polygon cross in their interiors. Sides that touch or coincide do not
/// cross. Tests all pairs of sides that overlap in x: at most n^2 / 2.
bool hasCrossings(const std::vector<Point2>& polygon);

}  // namespace sw
