#pragma once

#include <cstdint>

namespace sw {

/// A node of a Bvh: the boxes of its children. 256 bytes: four cache lines.
struct alignas(64) BvhNode {
    static constexpr int width = 8;  ///< children

    float planes[6][width];      ///< min x, y, z, max x, y, z of every child; empty: inf, -inf
    std::uint32_t child[width];  ///< see isLeaf()
    /// The children from the farthest to the nearest, three bits each, for every octant of
    /// directions (bit i: component i is negative).
    std::uint32_t order[width];

    // A child is a node's index, or a leaf: its start in Bvh::order() and its size.
    static constexpr std::uint32_t leafBit = 1u << 31;
    static constexpr int sizeShift = 28;
    static std::uint32_t leaf(std::uint32_t first, std::uint32_t count) {
        return leafBit | (count - 1) << sizeShift | first;
    }
    static bool isLeaf(std::uint32_t child) { return (child & leafBit) != 0; }
    static std::uint32_t leafFirst(std::uint32_t child) { return child & ((1u << sizeShift) - 1); }
    static std::uint32_t leafCount(std::uint32_t child) { return ((child >> sizeShift) & 7) + 1; }
    /// Whether the i-th child is a leaf that a ray can meet.
    bool hasLeaf(int i) const { return isLeaf(child[i]) && planes[0][i] <= planes[3][i]; }
};

}  // namespace sw
