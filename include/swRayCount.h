#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "swRay.h"

namespace sw {

/// How many rays were traced, by kind, and how many of them hit something. Rays that a program
/// makes itself count as `other`.
struct RayCount {
    std::array<std::uint64_t, 5> rays{};  ///< indexed by RayKind
    std::array<std::uint64_t, 5> hits{};

    std::uint64_t operator[](RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
    std::uint64_t hitsOf(RayKind kind) const { return hits[static_cast<std::size_t>(kind)]; }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const auto n : rays) sum += n;
        return sum;
    }
    /// Hits that traceRay() shades: all but those of shadow rays.
    std::uint64_t shaded() const {
        std::uint64_t sum = 0;
        for (const auto n : hits) sum += n;
        return sum - hitsOf(RayKind::shadow);
    }
    RayCount& operator+=(const RayCount& other) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i] += other.rays[i];
            hits[i] += other.hits[i];
        }
        return *this;
    }
};

/// This thread's count. A shared one would make the threads wait for each other.
inline thread_local constinit RayCount rayCount;

/// Counts a ray. Scene::intersect does so for every ray.
inline void countRay(RayKind kind, bool hit) {
    ++rayCount.rays[static_cast<std::size_t>(kind)];
    rayCount.hits[static_cast<std::size_t>(kind)] += hit;
}

/// Returns this thread's count and resets it.
inline RayCount takeRayCount() {
    return std::exchange(rayCount, RayCount());
}

}  // namespace sw
