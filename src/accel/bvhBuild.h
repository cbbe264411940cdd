#pragma once

// How a Bvh comes about. Boxes are kept as eight floats, {-min x, y, z, _, max x, y, z, _}, so that
// one maximum unites two of them.

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/simd.h"
#include "swBvh.h"

namespace sw::bvh {

using simd::Float;

/// A primitive's box; its number lies in the fourth lane, with numberBit set: a small integer
/// would be a denormal float, and arithmetic with those takes a hundred cycles.
constexpr std::uint32_t numberBit = 1u << 30;
struct alignas(32) Item {
    float lane[simd::lanes];
};

/// Neighbouring items with the box around them, and the box around the centres of their boxes.
struct Range {
    std::uint32_t first = 0, count = 0;
    Float box, centres;
};

/// Half the surface of a box whose coordinates are multiplied by scale, lest they overflow.
float halfArea(const Float& box, float scale);

Float emptyBox();

/// The centre of an item's box, as a box.
inline Float centre(const Float& box) {
    const Float half = box * simd::broadcast(0.5f);
    return half - simd::swapHalves(half);
}

/// Cuts ranges in two where the surface area heuristic says so.
class Splitter {
public:
    /// @param leafSize  primitives that are tested at once: the unit of cost
    Splitter(std::span<Item> all, std::uint32_t leafSize) : items(all), unit(leafSize) {}

    struct Cut {
        int axis = -1;           ///< -1: in the middle, by number
        int bin = 0;             ///< the last one on the left
        int bins = 0;            ///< how many there are
        float cost = HUGE_VALF;  ///< half area times cost of either side, summed
        Float left, right;       ///< boxes
    };

    /// All items. Also finds the scale in which areas neither overflow nor vanish.
    Range whole();
    /// The cheapest cut; axis -1 where the centres cannot be told apart.
    Cut findCut(const Range& range) const;
    /// Reorders the items of the range.
    void apply(const Cut& cut, const Range& range, Range& left, Range& right) const;
    void cutInTheMiddle(const Range& range, Range& left, Range& right) const;
    float area(const Range& range) const { return halfArea(range.box, scale); }

    /// Of testing that many primitives. Eight at a time cost no more than one.
    float cost(std::uint32_t count) const { return static_cast<float>((count + unit - 1) / unit); }

private:
    Range around(std::uint32_t first, std::uint32_t count) const;
    void sweep(const Float* boxes, const std::uint32_t* counts, int axis, Cut& best) const;

    std::span<Item> items;
    std::uint32_t unit;
    float scale = 1;
};

}  // namespace sw::bvh
