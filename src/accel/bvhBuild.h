#pragma once

// How a Bvh is built. A box is eight floats, {-min x, y, z, _, max x, y, z, _}, so that one maximum
// unites two boxes.

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/simd.h"
#include "swBounds.h"

namespace sw::bvh {

using simd::Float;

/// A primitive's box. The fourth and the last lane hold its number and its kind, both with
/// numberBit set: a small integer alone would be a denormal float, whose arithmetic takes a hundred
/// cycles.
constexpr std::uint32_t numberBit = 1u << 30;
struct alignas(32) Item {
    float lane[simd::lanes];

    std::uint32_t number() const { return std::bit_cast<std::uint32_t>(lane[3]) & ~numberBit; }
    bool hasKindOf(const Item& other) const { return lane[7] == other.lane[7]; }
};

/// Consecutive items, the box around them, and the box around their centroids.
struct Range {
    std::uint32_t first = 0, count = 0;
    Float box, centroids;
};

/// Half the surface area of a box. The coordinates are multiplied by scale first, so that nothing
/// overflows.
float halfArea(const Float& box, float scale);

Float emptyBox();

/// The centroid of an item's box, as a box without extent.
inline Float centroid(const Float& box) {
    const Float half = box * simd::broadcast(0.5f);
    return half - simd::swapHalves(half);
}

/// Splits ranges in two by the surface area heuristic (SAH).
class SahSplitter {
public:
    /// @param leafSize  how many primitives of one kind are tested at once: the unit of cost
    SahSplitter(std::span<Item> items, std::uint32_t leafSize) : leafSize(leafSize), items(items) {}

    const std::uint32_t leafSize;

    struct Split {
        int axis = -1;           ///< -1: none
        int bin = 0;             ///< the last bin on the left
        int bins = 0;            ///< how many bins there are
        float cost = HUGE_VALF;  ///< sum over both sides of half area times cost
        Float left, right;       ///< the boxes of both sides
    };

    /// The range of all items. Also sets the scale at which areas neither overflow nor vanish.
    Range whole();
    /// The cheapest split; axis -1 where all centroids are alike.
    Split findSplit(const Range& range) const;
    /// Reorders the items of the range: first those on the left, then those on the right. Without
    /// an axis, the range is split by kind if it would else be a leaf, or is halved by number.
    void partition(const Split& split, const Range& range, Range& left, Range& right) const;
    /// Whether a leaf may hold the range.
    bool isLeaf(const Range& range) const;
    float area(const Range& range) const { return halfArea(range.box, scale); }

    /// The cost of testing `count` primitives: leafSize of them cost no more than one.
    float cost(std::uint32_t count) const {
        return static_cast<float>((count + leafSize - 1) / leafSize);
    }

private:
    std::span<Item> in(const Range& range) const { return items.subspan(range.first, range.count); }
    Range around(std::uint32_t first, std::uint32_t count) const;
    void splitWithoutAxis(const Range& range, Range& left, Range& right) const;
    void sweep(const Float* boxes, const std::uint32_t* counts, int axis, Split& best) const;

    std::span<Item> items;
    float scale = 1;
};

}  // namespace sw::bvh
