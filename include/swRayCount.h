#pragma once

#include <array>
#include <cstdint>

#include "swRay.h"

namespace sw {

/// How many rays were traced, by kind. Rays that a program made itself count as `other`.
struct RayCount {
    std::array<std::uint64_t, 5> rays{};  ///< indexed by RayKind
    std::uint64_t primaryHits = 0;        ///< primary rays that hit something

    std::uint64_t operator[](RayKind kind) const { return rays[static_cast<std::size_t>(kind)]; }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const auto n : rays) sum += n;
        return sum;
    }
    RayCount& operator+=(const RayCount& other) {
        for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
        primaryHits += other.primaryHits;
        return *this;
    }
};

/// Notes a ray in this thread's count. Scene::intersect does so for every ray.
void countRay(RayKind kind, bool hit);

/// Returns this thread's count and starts it anew.
RayCount takeRayCount();

}  // namespace sw
