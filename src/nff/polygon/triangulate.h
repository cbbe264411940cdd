#pragma once

#include <span>

#include "nff/polygon/triangulation.h"
#include "swVec3.h"

namespace sw {

/// Triangulates a planar polygon, convex or not.
///
/// The triangles cover the polygon exactly and do not overlap. No corner lies on the
/// edge of another triangle, where rays could slip through: corners in the middle of a straight
/// side are kept. Only repeated corners and spikes of zero area may be left out. A line or a point
/// gives no triangles. Holes may be bridged to the outline by a pair of coinciding edges.
///
/// Takes quadratic time at worst: less than a second for any 10,000 corners.
/// @param corners  at least three, with finite coordinates; else the result is empty
Triangulation triangulate(std::span<const Vec3> corners);

}  // namespace sw
