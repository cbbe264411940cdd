#pragma once

// How a Bvh is built. A box is eight floats, {-min x, y, z, _, max x, y, z, _}, so that one maximum
// unites two boxes.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/simd.h"
#include "swBounds.h"
#include "swBvhNode.h"

namespace sw::bvh {

using simd::Float;

/// A primitive's box. The fourth lane holds its number with numberBit set: a small integer alone
/// would be a denormal float, and arithmetic with those takes a hundred cycles.
constexpr std::uint32_t numberBit = 1u << 30;
struct alignas(32) Item {
    float lane[simd::lanes];

    std::uint32_t number() const { return std::bit_cast<std::uint32_t>(lane[3]) & ~numberBit; }
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

/// Which primitives may share a leaf: those of one run, up to its leaf size.
class LeafRule {
public:
    explicit LeafRule(std::span<const BvhRun> runs);

    std::uint32_t largest() const { return most; }  ///< leaf of any run
    std::size_t runOf(std::uint32_t primitive) const {
        return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), primitive) -
                                        ends.begin());
    }
    bool allows(std::span<const Item> items) const;
    /// Sorts items by their runs. Returns how many belong to the first one.
    std::uint32_t sortByRun(std::span<Item> items) const;
    /// Where each run starts in the tree's order.
    std::vector<std::uint32_t> starts() const;

private:
    std::vector<std::uint32_t> ends, sizes;  // of the runs and of their leaves
    std::uint32_t most = 1;
};

/// Splits ranges in two by the surface area heuristic (SAH).
class SahSplitter {
public:
    /// @param leafSize  how many primitives are tested at once: the unit of cost
    SahSplitter(std::span<Item> items, std::uint32_t leafSize) : items(items), leafSize(leafSize) {}

    /// The items of a range.
    std::span<Item> in(const Range& range) const { return items.subspan(range.first, range.count); }

    struct Split {
        int axis = -1;           ///< -1: none; halve the range by number
        int bin = 0;             ///< the last bin on the left
        int bins = 0;            ///< how many bins there are
        float cost = HUGE_VALF;  ///< sum over both sides of half area times cost
        Float left, right;       ///< the boxes of both sides
    };

    /// The range of all items. Also sets the scale at which areas neither overflow nor vanish.
    Range whole();
    /// The cheapest split; axis -1 where all centroids are alike.
    Split findSplit(const Range& range) const;
    /// Reorders the items of the range: first those on the left, then those on the right.
    void partition(const Split& split, const Range& range, Range& left, Range& right) const;
    /// Splits a range after its first items.
    void splitAfter(std::uint32_t count, const Range& range, Range& left, Range& right) const;
    float area(const Range& range) const { return halfArea(range.box, scale); }

    /// The cost of testing `count` primitives: leafSize of them cost no more than one.
    float cost(std::uint32_t count) const {
        return static_cast<float>((count + leafSize - 1) / leafSize);
    }

private:
    Range around(std::uint32_t first, std::uint32_t count) const;
    void sweep(const Float* boxes, const std::uint32_t* counts, int axis, Split& best) const;

    std::span<Item> items;
    std::uint32_t leafSize;
    float scale = 1;
};

}  // namespace sw::bvh
