#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sw {

/// A polygon cut into triangles.
struct Triangulation {
    /// Indices into the corners, in the same orientation.
    std::vector<std::array<std::uint32_t, 3>> triangles;

    /// False: corners stand off the plane by more than a thousandth of the polygon's extent.
    /// Coordinates with four digits stay within that, and such small dents are invisible.
    bool planar = true;

    /// False: edges cross, and the triangles are a best effort.
    bool simple = true;

    /// Corners examined in the search for ears. Tests check how this number grows.
    std::size_t steps = 0;
};

}  // namespace sw
