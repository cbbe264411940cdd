#pragma once

#include <limits>

#include "swVec3.h"

namespace sw {

/// Axis-aligned box. Empty until something is added.
struct Bounds {
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    Vec3 min{infinity, infinity, infinity};
    Vec3 max{-infinity, -infinity, -infinity};

    Bounds() = default;
    Bounds(const Vec3& min, const Vec3& max) : min(min), max(max) {}

    /// All of space: the box of a primitive that does not state its own.
    static Bounds unbounded() {
        return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
    }

    /// Makes the box just large enough to hold b as well. A NaN coordinate changes nothing.
    void add(const Bounds& b) {
        for (int i = 0; i < 3; ++i) {
            if (b.min[i] < min[i]) min[i] = b.min[i];
            if (b.max[i] > max[i]) max[i] = b.max[i];
        }
    }
    void add(const Vec3& p) { add(Bounds(p, p)); }

    /// True if the box is not empty and ends on every side.
    bool isFinite() const {
        for (int i = 0; i < 3; ++i)
            if (!(min[i] <= max[i] && min[i] > -infinity && max[i] < infinity)) return false;
        return true;
    }
};

}  // namespace sw
