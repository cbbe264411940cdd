#pragma once

#include <vector>

#include "nff/polygon/orientation.h"

namespace sw {

/// Whether any two sides of a polygon cross in a point that is an end of neither. Sides that touch
/// or coincide do not cross. Looks at all pairs of sides that overlap in x: n^2 / 2 at most.
bool hasCrossings(const std::vector<Point2>& polygon);

}  // namespace sw
