#pragma once

#include <array>
#include <cstdint>

#include "swRay.h"

namespace sw {

/// Why a ray was not cast.
enum class LeftOut : unsigned char {
    shadowZeroWeight,    ///< the surface faces the light, but scatters nothing of it
    shadowFacingAway,    ///< the surface faces away from the light
    secondaryZeroWeight  ///< a reflected or refracted ray of weight 0
};

/// How many rays were traced, by kind, and how many were left out. Rays that a program made itself
/// count as `other`.
struct RayCount {
    std::array<std::uint64_t, 5> rays{};     ///< indexed by RayKind
    std::array<std::uint64_t, 3> leftOut{};  ///< indexed by the reason
    std::uint64_t primaryHits = 0;           ///< primary rays that hit something

    std::uint64_t operator[](RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
    std::uint64_t operator[](LeftOut why) const { return leftOut[static_cast<std::size_t>(why)]; }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const auto n : rays) sum += n;
        return sum;
    }
    RayCount& operator+=(const RayCount& other) {
        for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
        for (std::size_t i = 0; i < leftOut.size(); ++i) leftOut[i] += other.leftOut[i];
        primaryHits += other.primaryHits;
        return *this;
    }
};

/// Notes a ray in this thread's count. Scene::intersect does so for every ray.
void countRay(RayKind kind, bool hit);

/// Notes rays that were not cast, for the statistics' sake.
void leaveOut(LeftOut why, int rays = 1);

/// Returns this thread's count and starts it anew.
RayCount takeRayCount();

}  // namespace sw
