#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

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

/// This thread's count: a shared one would make the threads wait for each other.
inline thread_local constinit RayCount rayCount;

/// Notes a ray. Scene::intersect does so for every ray.
inline void countRay(RayKind kind, bool hit) {
    ++rayCount.rays[static_cast<std::size_t>(kind)];
    if (hit && kind == RayKind::primary) ++rayCount.primaryHits;
}

/// Notes rays that were not cast.
inline void leaveOut(LeftOut why, int rays = 1) {
    rayCount.leftOut[static_cast<std::size_t>(why)] += static_cast<std::uint64_t>(rays);
}

/// Returns this thread's count and starts it anew.
inline RayCount takeRayCount() {
    return std::exchange(rayCount, RayCount());
}

}  // namespace sw
