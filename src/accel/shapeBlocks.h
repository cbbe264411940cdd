#pragma once

#include <array>
#include <bit>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "accel/largePages.h"
#include "accel/search.h"
#include "accel/shapeRows.h"
#include "swBvhNode.h"

namespace sw {
namespace {

using Foreign = std::shared_ptr<Primitive>;

/// Of foreign primitives, a block knows the numbers alone.
template <>
struct Rows<Foreign> {
    static constexpr std::size_t count = 0;
};

/// Tests the shapes that a filter lets through. Returns whether the search is over.
/// @param used  one bit for each shape
/// @param test  bool(std::uint32_t i): tests the i-th one
template <Find what, typename Filter, typename Test>
SW_INLINE bool testEach(Search<what>& search, const Filter& filter, unsigned used,
                        const Test& test) {
    unsigned left = used & ~filter.missed();
    if (what == Find::whether && left != 0 && (used & filter.hit()) != 0) return search.end();
    for (; left != 0; left &= left - 1)
        if (test(static_cast<std::uint32_t>(std::countr_zero(left)))) return true;
    return false;
}

/// Shapes in blocks, one block after the other in memory. A block holds up to eight shapes of one
/// type: a head, then row by row their coordinates, their materials' numbers, and their own.
class ShapeBlocks {
    static constexpr std::size_t unit = 8;  // floats; blocks start at multiples of it

public:
    /// How many floats a block takes.
    template <typename Shape>
    static std::size_t size(std::size_t count) {
        return (1 + (Rows<Shape>::count + 2) * count + unit - 1) / unit * unit;
    }

    /// Asks for memory for all blocks.
    void reserve(std::size_t floats) {
        pool.reserve(floats + unit);
        preferLargePages(pool.data(), floats * sizeof(float));
    }

    /// Appends a block.
    /// @param type   what typeOf() will say
    /// @param shape  const Shape&(std::uint32_t number)
    /// @return       the block's place, below 2^28
    template <typename Shape, typename ShapeOf>
    std::uint32_t add(std::uint8_t type, std::span<const std::uint32_t> numbers,
                      const ShapeOf& shape) {
        const std::size_t start = end, count = numbers.size();
        end += size<Shape>(count);
        if (end / unit > 1u << BvhNode::sizeShift)
            throw std::length_error("Scene: expected at most 8 GB of shapes");
        pool.resize(end + unit);  // a filter reads eight floats at a time
        const auto units = static_cast<std::uint16_t>((end - start) / unit);
        const Head head{type, static_cast<std::uint8_t>(count), units};
        pool[start] = std::bit_cast<float>(head);
        for (std::size_t i = 0; i < count; ++i)
            write(shape(numbers[i]), numbers[i], {&pool[start + 1 + i], count});
        return static_cast<std::uint32_t>(start / unit);
    }
    /// To be called after the last block.
    void finish() { known.clear(); }

    std::uint8_t typeOf(std::uint32_t place) const { return headAt(place * unit).type; }

    /// Tests the shapes of a block, which are no foreign ones. Returns whether the search is over.
    template <typename Shape, Find what>
    SW_INLINE bool test(Search<what>& search, std::uint32_t place) const {
        const std::uint32_t count = headAt(place * unit).count;
        const float* const row = &pool[place * unit + 1];
        return testEach(search, Rows<Shape>::filter(search.filterRay, row, count),
                        (1u << count) - 1, [&](std::uint32_t i) {
                            const Column<const float> from{row + i, count};
                            return search.test(shapeIn<Shape>(from), numberIn<Shape>(from));
                        });
    }
    /// The number of the foreign primitive that is alone in a block.
    std::uint32_t foreignNumber(std::uint32_t place) const {
        return numberIn<Foreign>({&pool[place * unit + 1], 1});
    }

    /// Calls visit(shape, number) for every shape of a type that is no foreign one.
    template <typename Shape, typename Visit>
    void eachShape(std::uint8_t type, const Visit& visit) const {
        for (std::size_t start = 0; start < end; start += headAt(start).units * unit) {
            const Head head = headAt(start);
            for (std::size_t i = 0; i < head.count && head.type == type; ++i) {
                const Column<const float> from{&pool[start + 1 + i], head.count};
                visit(shapeIn<Shape>(from), numberIn<Shape>(from));
            }
        }
    }

private:
    struct Head {
        std::uint8_t type, count;
        std::uint16_t units;
    };
    Head headAt(std::size_t start) const { return std::bit_cast<Head>(pool[start]); }

    // The last two rows.
    template <typename Shape>
    static constexpr std::size_t material = Rows<Shape>::count;
    template <typename Shape>
    static constexpr std::size_t number = material<Shape> + 1;

    template <typename Shape>
    void write(const Shape& shape, std::uint32_t itsNumber, Column<float> to) {
        to[number<Shape>] = std::bit_cast<float>(itsNumber);
        if constexpr (!std::is_same_v<Shape, Foreign>) {
            Rows<Shape>::write(shape, to);
            to[material<Shape>] = std::bit_cast<float>(numberOf(shape.material));
        }
    }
    template <typename Shape>
    Shape shapeIn(Column<const float> from) const {
        Shape shape;  // filled in place: reading back what was just written is slow
        Rows<Shape>::read(from, shape);
        shape.material = materials[std::bit_cast<std::uint32_t>(from[material<Shape>])];
        return shape;
    }
    template <typename Shape>
    static std::uint32_t numberIn(Column<const float> from) {
        return std::bit_cast<std::uint32_t>(from[number<Shape>]);
    }

    // Equal materials are kept once; by their bits, as NaN is not equal to itself.
    using MaterialBits = std::array<std::uint32_t, sizeof(Material) / sizeof(std::uint32_t)>;
    std::uint32_t numberOf(const Material& wanted) {
        const auto next = static_cast<std::uint32_t>(materials.size());
        const auto [place, isNew] = known.try_emplace(std::bit_cast<MaterialBits>(wanted), next);
        if (isNew) materials.push_back(wanted);
        return place->second;
    }

    std::vector<float> pool;
    std::size_t end = 0;  // of the last block
    std::vector<Material> materials;
    std::map<MaterialBits, std::uint32_t> known;
};

}  // namespace
}  // namespace sw
