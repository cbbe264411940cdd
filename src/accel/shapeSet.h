#pragma once

#include <array>
#include <bit>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "accel/largePages.h"
#include "accel/search.h"
#include "accel/shapePackets.h"
#include "swBvh.h"

namespace sw {
namespace {

/// Tests candidates. Returns whether the search is over.
/// @param test  bool(std::uint32_t i): tests the i-th shape
template <typename Search, typename Test>
bool testEach(Search& search, const Candidates& candidates, const Test& test) {
    if (Search::onlyWhether && candidates.certain != 0) return search.end();
    for (unsigned set = candidates.possible; set != 0; set &= set - 1)
        if (test(static_cast<std::uint32_t>(std::countr_zero(set)))) return true;
    return false;
}

/// The leaves of a tree that hold shapes of one type.
template <typename Shape>
class Leaves {
public:
    static constexpr int leafSize = 8;  ///< most shapes per leaf

    /// @param order   the numbers of the shapes plus `offset`, leaf after leaf
    /// @param sizes   where a leaf starts, how many shapes it holds
    void assign(const std::vector<Shape>& shapes, std::span<const std::uint32_t> order,
                std::span<const std::uint32_t> sizes, std::uint32_t offset) {
        // The padding at the end lets the last row be read as eight values.
        const std::size_t size = order.size() * Rows<Shape>::count + lanes;
        rows.reserve(size);
        preferLargePages(rows.data(), size * sizeof(float));
        rows.resize(size);
        materials.clear();
        std::map<MaterialBits, std::uint32_t> known;
        for (std::size_t first = 0; first < order.size(); first += sizes[first]) {
            for (std::size_t i = 0; i < sizes[first]; ++i) {
                const Shape& shape = shapes[order[first + i] - offset];
                float* const row = rows.data() + first * Rows<Shape>::count;
                const Column<float> to{row + i, sizes[first]};
                Rows<Shape>::write(shape, to);
                to[Rows<Shape>::count - 1] = std::bit_cast<float>(numberOf(shape.material, known));
            }
        }
    }

    /// @param first  the leaf's first place in the order
    /// @param count  how many shapes the leaf holds
    template <bool wantHit>
    Candidates ask(const FilterRay& ray, std::size_t first, std::uint32_t count) const {
        const float* row = rows.data() + Rows<Shape>::count * first;
        return Candidates(Rows<Shape>::filter(ray, row, count), (1u << count) - 1, wantHit);
    }

    /// The i-th shape of a leaf, as it was.
    Shape shape(std::size_t first, std::uint32_t count, std::uint32_t i) const {
        const Column<const float> from{rows.data() + Rows<Shape>::count * first + i, count};
        Shape shape;  // filled in place: reading back what was just written is slow
        Rows<Shape>::read(from, shape);
        shape.material = materials[std::bit_cast<std::uint32_t>(from[Rows<Shape>::count - 1])];
        return shape;
    }

private:
    // By its bits, as NaN is not equal to itself.
    using MaterialBits = std::array<std::uint32_t, sizeof(Material) / sizeof(std::uint32_t)>;

    // Equal materials are kept once.
    std::uint32_t numberOf(const Material& material, std::map<MaterialBits, std::uint32_t>& known) {
        const auto next = static_cast<std::uint32_t>(materials.size());
        const auto [place, isNew] = known.try_emplace(std::bit_cast<MaterialBits>(material), next);
        if (isNew) materials.push_back(material);
        return place->second;
    }

    std::vector<float> rows;
    std::vector<Material> materials;
};

/// Foreign primitives have no filter other than their boxes.
template <>
class Leaves<std::shared_ptr<Primitive>> {
public:
    using Shape = std::shared_ptr<Primitive>;
    static constexpr int leafSize = 1;

    void assign(const std::vector<Shape>& all, std::span<const std::uint32_t> order,
                std::span<const std::uint32_t>, std::uint32_t offset) {
        shapes.clear();
        for (const std::uint32_t i : order) shapes.push_back(all[i - offset]);
    }
    template <bool wantHit>
    Candidates ask(const FilterRay&, std::size_t, std::uint32_t) const {
        return {1, 0};
    }
    const Shape& shape(std::size_t first, std::uint32_t, std::uint32_t) const {
        return shapes[first];
    }

private:
    std::vector<Shape> shapes;
};

/// The shapes of one type in a scene: those in leaves of the scene's tree, and the others in
/// packets. In order, all leaves of the set follow each other, as do its shapes' numbers.
template <typename Shape>
class ShapeSet {
public:
    static constexpr int leafSize = Leaves<Shape>::leafSize;

    std::size_t size() const { return lastPlace - firstPlace + outside.size(); }

    void push(Shape shape) { outside.push_back(std::move(shape)); }

    /// Appends the boxes of those that a tree can hold, which move to the front.
    void addBoxes(std::vector<Bounds>& boxes) {
        std::stable_partition(outside.begin(), outside.end(),
                              [](const Shape& s) { return boundsOf(s).isFinite(); });
        for (const Shape& shape : outside) {
            const Bounds box = boundsOf(shape);
            if (box.isFinite()) boxes.push_back(box);
        }
    }

    /// Moves the shapes in front into leaves.
    /// @param order  their numbers, leaf after leaf; the first one's number is `first`
    /// @param sizes  where a leaf starts, how many shapes it holds
    /// @param first  the place of the first leaf
    void moveToLeaves(std::span<const std::uint32_t> order, std::span<const std::uint32_t> sizes,
                      std::size_t first) {
        const auto end = outside.begin() + static_cast<std::ptrdiff_t>(order.size());
        std::vector<Shape> rest(std::make_move_iterator(end),
                                std::make_move_iterator(outside.end()));
        firstPlace = static_cast<std::uint32_t>(first);
        lastPlace = static_cast<std::uint32_t>(first + order.size());
        leaves.assign(outside, order, sizes, firstPlace);
        outside = std::move(rest);
    }

    /// The reverse: the shapes are as they were before.
    void takeFromLeaves(const Bvh& tree) {
        std::vector<Shape> all(lastPlace - firstPlace);
        tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) {
            if (first < firstPlace || first >= lastPlace) return;
            for (std::uint32_t i = 0; i < count; ++i)
                all[tree.order()[first + i] - firstPlace] =
                    leaves.shape(first - firstPlace, count, i);
        });
        outside.insert(outside.begin(), std::make_move_iterator(all.begin()),
                       std::make_move_iterator(all.end()));
        leaves = {};
        firstPlace = lastPlace = 0;
    }

    /// Packs the shapes outside the tree.
    /// @param place  of the first of them
    /// @return       the place after the last one
    std::uint32_t pack(std::uint32_t place) {
        firstOutside = place;
        packets.clear();
        std::vector<std::uint32_t> pending(outside.size());
        std::iota(pending.begin(), pending.end(), 0);
        while (!pending.empty()) packets.emplace_back(outside, pending);
        return place + static_cast<std::uint32_t>(outside.size());
    }

    template <typename Search>
    bool findOutside(Search& search) const {
        for (const Packet<Shape>& packet : packets) {
            const auto test = [&](std::uint32_t i) {
                const std::uint32_t number = packet.number(i);
                return search.test(outside[number], firstOutside + number);
            };
            if (testEach(search, packet.template ask<Search::onlyWhether>(search.filterRay), test))
                return true;
        }
        return false;
    }

    /// The place after the last one in the tree.
    std::uint32_t endPlace() const { return lastPlace; }

    template <typename Search>
    bool findInLeaf(Search& search, std::uint32_t first, std::uint32_t count) const {
        const std::uint32_t start = first - firstPlace;
        const auto test = [&](std::uint32_t i) {
            return search.test(leaves.shape(start, count, i), first + i);
        };
        return testEach(
            search, leaves.template ask<Search::onlyWhether>(search.filterRay, start, count), test);
    }

private:
    static Bounds boundsOf(const Primitive& shape) { return shape.bounds(); }
    static Bounds boundsOf(const std::shared_ptr<Primitive>& shape) { return shape->bounds(); }

    std::vector<Shape> outside;  // of the tree
    std::vector<Packet<Shape>> packets;
    Leaves<Shape> leaves;
    std::uint32_t firstPlace = 0, lastPlace = 0, firstOutside = 0;
};

}  // namespace
}  // namespace sw
