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

// A few shapes of one type, looked at one block after the other. For a dozen of them that is faster
// than any tree.

namespace sw {

/// Up to eight spheres.
class SphereBlock {
public:
    /// Up to about this many, looking at all shapes takes no longer than finding a way among them.
    /// Measured on scattered shapes: 48 to 64 spheres, 32 triangles.
    static constexpr int few = 32;

    /// @param all      of which at most eight are taken
    /// @param pending  numbers of spheres; those taken are removed
    SphereBlock(std::span<const Sphere> all, std::vector<std::uint32_t>& pending);

    /// One bit for each shape that the ray may hit.
    unsigned candidates(const FilterRay& ray) const;

    /// The number of the shape that a bit stands for.
    std::uint32_t number(int bit) const { return numbers[static_cast<std::size_t>(bit)]; }

private:
    float center[3][simd::lanes] = {}, radius[simd::lanes] = {};
    std::array<std::uint32_t, simd::lanes> numbers{};
    unsigned used = 0;  // bits that stand for a sphere
};

/// Up to eight triangles or parallelograms, each of the latter two triangles: walls and boxes are
/// made of them.
class TriangleBlock {
public:
    static constexpr int few = 32;

    TriangleBlock(std::span<const Triangle> all, std::vector<std::uint32_t>& pending);
    unsigned candidates(const FilterRay& ray) const;
    std::uint32_t number(int bit) const { return numbers[static_cast<std::size_t>(bit)]; }

private:
    void setEntry(std::size_t lane, const Triangle& triangle, int corner);

    float v0[3][simd::lanes] = {}, e1[3][simd::lanes] = {}, e2[3][simd::lanes] = {};
    float extent[simd::lanes] = {};
    std::array<std::uint32_t, 2 * simd::lanes> numbers{};  // first triangles, then second ones
    unsigned used = 0;
};

/// Up to eight shapes without a filter: every one is a candidate.
class PlainBlock {
public:
    static constexpr int few = 1;  // a tree's boxes are the filter

    template <typename Shapes>
    PlainBlock(const Shapes&, std::vector<std::uint32_t>& pending)
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
