#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/filterRay.h"
#include "accel/simd.h"
#include "swSphere.h"
#include "swTriangle.h"

// Packets of up to eight shapes of one type, for a linear scan: with a dozen shapes that is faster
// than any tree.

namespace sw {

/// Up to eight spheres.
class SpherePacket {
public:
    /// Up to this count a linear scan is as fast as a tree. Measured on scattered shapes: 48 to 64
    /// spheres, 32 triangles.
    static constexpr int linearLimit = 32;

    /// Takes at most eight spheres.
    /// @param all      the spheres
    /// @param pending  the numbers of those to choose from; what is taken is removed
    SpherePacket(std::span<const Sphere> all, std::vector<std::uint32_t>& pending);

    /// One bit for each sphere that the ray may hit.
    unsigned candidates(const FilterRay& ray) const;

    /// The number of the sphere that a bit stands for.
    std::uint32_t number(int bit) const { return numbers[static_cast<std::size_t>(bit)]; }

private:
    float center[3][simd::lanes] = {}, radius[simd::lanes] = {};
    std::array<std::uint32_t, simd::lanes> numbers{};
    unsigned used = 0;  // bits that stand for a sphere
};

/// Up to eight triangles or parallelograms: pairs of triangles, as in walls and boxes.
class TrianglePacket {
public:
    static constexpr int linearLimit = 32;

    TrianglePacket(std::span<const Triangle> all, std::vector<std::uint32_t>& pending);
    unsigned candidates(const FilterRay& ray) const;
    std::uint32_t number(int bit) const { return numbers[static_cast<std::size_t>(bit)]; }

private:
    void setEntry(std::size_t lane, const Triangle& triangle, int corner);

    float v0[3][simd::lanes] = {}, e1[3][simd::lanes] = {}, e2[3][simd::lanes] = {};
    float extent[simd::lanes] = {};
    std::array<std::uint32_t, 2 * simd::lanes> numbers{};  // first triangles, then second ones
    unsigned used = 0;
};

/// Up to eight shapes without a filter: each is a candidate.
class PlainPacket {
public:
    static constexpr int linearLimit = 1;  // a tree's boxes are the filter

    template <typename Shapes>
    PlainPacket(const Shapes&, std::vector<std::uint32_t>& pending)
        : first(pending.front()),
          used((1u << std::min<std::size_t>(pending.size(), simd::lanes)) - 1) {
        pending.erase(pending.begin(), pending.begin() + std::popcount(used));
    }
    unsigned candidates(const FilterRay&) const { return used; }
    std::uint32_t number(int bit) const { return first + static_cast<std::uint32_t>(bit); }

private:
    std::uint32_t first;
    unsigned used;
};

}  // namespace sw
