#pragma once

#include <span>

#include "nff/polygon/triangulation.h"
#include "swVec3.h"

namespace sw {

/// Cuts a plane polygon, convex or not, into triangles between its corners.
///
/// The triangles cover the polygon exactly and do not overlap. A corner never lies on another
/// triangle's edge, as rays could slip through there: corners in the middle of a straight side are
/// kept. Only repeated corners and spikes, whose area is zero, may be left out; nothing is left of
/// a polygon that is a line or a point. Holes may be bridged to the outline by a pair of coinciding
/// edges.
///
/// Takes quadratic time at worst, whatever the corners: less than a second for 10,000.
/// @param corners  at least three, with finite coordinates; else the result is empty
Triangulation triangulate(std::span<const Vec3> corners);

}  // namespace sw
