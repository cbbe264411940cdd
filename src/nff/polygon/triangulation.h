#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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

    /// What the search for ears cost, in corners looked at. For tests of its growth.
    std::size_t steps = 0;
};

}  // namespace sw
