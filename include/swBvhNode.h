#pragma once

#include <cstddef>
#include <cstdint>

namespace sw {

/// Consecutive boxes of one kind.
struct BvhRun {
    std::size_t count;  ///< how many boxes
    int leafSize;       ///< the most primitives per leaf, 1..8
};

/// A node of a Bvh: the boxes of its children. 256 bytes: four cache lines.
struct alignas(64) BvhNode {
    static constexpr int width = 8;  ///< children

    float planes[6][width];      ///< min x, y, z, max x, y, z of every child; empty: inf, -inf
    std::uint32_t child[width];  ///< see isLeaf()
    /// The children from the farthest to the nearest, three bits each, for every octant of
    /// directions (bit i: component i is negative).
    std::uint32_t order[width];

    // A child is a node's index, or the range of a leaf: its start in Bvh::order() and its
    // size.
    static constexpr std::uint32_t leafBit = 1u << 31;
    static constexpr int sizeShift = 28;
    static bool isLeaf(std::uint32_t child) { return (child & leafBit) != 0; }
    static std::uint32_t leafFirst(std::uint32_t child) { return child & ((1u << sizeShift) - 1); }
    static std::uint32_t leafCount(std::uint32_t child) { return ((child >> sizeShift) & 7) + 1; }
};

}  // namespace sw
