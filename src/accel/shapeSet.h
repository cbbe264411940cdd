#pragma once

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>
#include <vector>

#include "accel/bvhTraversal.h"
#include "accel/search.h"
#include "accel/simd.h"

namespace sw {

/// Shapes of one type. A few are looked at block by block; many stand in a tree.
/// @tparam Block   up to eight of the few; see flatShapes.h
/// @tparam Leaves  the leaves of the tree; see shapeBlocks.h
template <typename Shape, typename Block, typename Leaves>
class ShapeSet {
public:
    void push(Shape shape) {
        takeFromTree();
        few.push_back(std::move(shape));
    }

    /// Must be called between the last push and the first search.
    void prepare(int threads) {
        const auto unbounded = std::stable_partition(
            few.begin(), few.end(), [](const Shape& s) { return boundsOf(s).isFinite(); });
        if (unbounded - few.begin() > Block::few) plantTree(unbounded, threads);
        blocks.clear();
        std::vector<std::uint32_t> pending(few.size());
        std::iota(pending.begin(), pending.end(), 0);
        while (!pending.empty()) blocks.emplace_back(few, pending);
    }

    std::size_t size() const { return few.size() + tree.order().size(); }
    bool hasTree() const { return planted; }

    /// Returns whether the search is over.
    bool find(Search& search) const {
        if (hasTree() && findInTree(search)) return true;
        for (const Block& block : blocks)
            if (testEach(search, block.candidates(search.filterRay),
                         [&](int i) -> const Shape& { return few[block.number(i)]; }))
                return true;
        return false;
    }

private:
    static Bounds boundsOf(const Primitive& shape) { return shape.bounds(); }
    static Bounds boundsOf(const std::shared_ptr<Primitive>& shape) { return shape->bounds(); }

    // Moves the shapes before `end` into the tree.
    void plantTree(typename std::vector<Shape>::iterator end, int threads) {
        std::vector<Shape> rest(std::make_move_iterator(end), std::make_move_iterator(few.end()));
        few.erase(end, few.end());
        std::vector<Bounds> boxes;
        boxes.reserve(few.size());
        for (const Shape& shape : few) boxes.push_back(boundsOf(shape));
        tree = Bvh(boxes, Leaves::size, threads);
        planted = true;
        boxes = {};
        leaves.assign(std::exchange(few, std::move(rest)), tree.order(), leafSizes());
    }

    // In the order of their shapes.
    std::vector<int> leafSizes() const {
        std::vector<int> startingAt(tree.order().size());  // 0: no leaf starts here
        tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) {
            startingAt[first] = static_cast<int>(count);
        });
        std::erase(startingAt, 0);
        return startingAt;
    }

    void takeFromTree() {
        if (!hasTree()) return;
        tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) {
            const int n = static_cast<int>(count);
            for (int i = 0; i < n; ++i) few.push_back(leaves.shape(first, n, i));
        });
        tree = Bvh();
        leaves = Leaves();
        planted = false;
    }

    // What the traversal does with a leaf.
    struct LeafTest {
        const Leaves& leaves;
        Search& search;
        bool over = false;

        bool operator()(std::uint32_t first, std::uint32_t count, float& maxT) {
            const int n = static_cast<int>(count);
            over = testEach(search, leaves.candidates(search.filterRay, first, n),
                            [&](int i) -> decltype(auto) { return leaves.shape(first, n, i); });
            maxT = search.ray().maxT;
            return over;
        }
        void prefetch(std::uint32_t first, std::uint32_t count) const {
            leaves.prefetch(first, static_cast<int>(count));
        }
    };

    bool findInTree(Search& search) const {
        LeafTest leaf{leaves, search};
        tree.traverse(search.ray(), leaf);
        return leaf.over;
    }

    // Returns whether the search is over.
    template <typename Get>
    static bool testEach(Search& search, unsigned candidates, const Get& get) {
        for (; candidates != 0; candidates &= candidates - 1)
            if (search.test(get(std::countr_zero(candidates)))) return true;
        return false;
    }

    std::vector<Shape> few;  // not in the tree
    std::vector<Block> blocks;
    Bvh tree;
    Leaves leaves;
    bool planted = false;
};

}  // namespace sw
