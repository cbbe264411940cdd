#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "swVec3.h"

namespace sw {

/// A polygon cut into triangles.
struct Triangulation {
    /// Indices into the corners; counter-clockwise where the corners are.
    std::vector<std::array<std::uint32_t, 3>> triangles;

    /// False: corners stand off the plane by more than a thousandth of the polygon's extent.
    /// Coordinates with four digits keep within that, and the dents that remain do not show.
    bool planar = true;

    /// False: edges cross, and the triangles are a best effort.
    bool simple = true;

    /// What the search for cuts cost, in boxes looked at. For tests of its growth.
    std::size_t steps = 0;
};

/// Cuts a plane polygon, convex or not, into triangles between its corners.
///
/// The triangles cover the polygon exactly and do not overlap. A corner never lies on another
/// triangle's edge, as rays could slip through there: corners in the middle of a straight side are
/// kept. Only repeated corners and spikes, whose area is zero, may be left out; nothing is left of
/// a polygon that is a line or a point. Holes may be bridged to the outline by a pair of coinciding
/// edges.
///
/// Takes about n log n steps for n corners, n sqrt(n) where long thin spikes lie side by side. The
/// work on a polygon that crosses itself is bounded: what is not cut by then becomes a fan.
/// @param corners  at least three, with finite coordinates; else the result is empty
Triangulation triangulate(std::span<const Vec3> corners);

}  // namespace sw
