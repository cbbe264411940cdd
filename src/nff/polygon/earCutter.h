#pragma once

#include <vector>

#include "nff/polygon/orientation.h"
#include "nff/polygon/triangulation.h"

namespace sw {

/// Triangulates a polygon by ear clipping. An ear is a corner whose triangle with its two
/// neighbours lies inside the polygon (Meisters, Polygons Have Ears, 1975).
/// @param points  the corners, counter-clockwise
void cutEars(const std::vector<Point2>& points, Triangulation& result);

}  // namespace sw
