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

/// Shapes of one type. A few are scanned packet by packet; many go into a tree.
/// @tparam Packet  up to eight shapes outside the tree; see shapePackets.h
/// @tparam Leaves  the leaves of the tree; see shapeLeaves.h
template <typename Shape, typename Packet, typename Leaves>
class ShapeSet {
public:
    void push(Shape shape) {
        dissolveTree();
        outside.push_back(std::move(shape));
    }

    /// Call this between the last push and the first search.
    void prepare(int threads) {
        const auto unbounded = std::stable_partition(
            outside.begin(), outside.end(), [](const Shape& s) { return boundsOf(s).isFinite(); });
        if (unbounded - outside.begin() > Packet::linearLimit) buildTree(unbounded, threads);
        packets.clear();
        std::vector<std::uint32_t> pending(outside.size());
        std::iota(pending.begin(), pending.end(), 0);
        while (!pending.empty()) packets.emplace_back(outside, pending);
    }

    std::size_t size() const { return outside.size() + tree.order().size(); }
    bool hasTree() const { return treeBuilt; }

    /// Returns whether the search is over.
    bool find(Search& search) const {
        if (hasTree() && findInTree(search)) return true;
        for (const Packet& packet : packets)
            if (testEach(search, packet.candidates(search.filterRay),
                         [&](int i) -> const Shape& { return outside[packet.number(i)]; }))
                return true;
        return false;
    }

private:
    static Bounds boundsOf(const Primitive& shape) { return shape.bounds(); }
    static Bounds boundsOf(const std::shared_ptr<Primitive>& shape) { return shape->bounds(); }

    // Moves the shapes before `end` into the tree.
    void buildTree(typename std::vector<Shape>::iterator end, int threads) {
        std::vector<Shape> rest(std::make_move_iterator(end),
                                std::make_move_iterator(outside.end()));
        outside.erase(end, outside.end());
        std::vector<Bounds> boxes;
        boxes.reserve(outside.size());
        for (const Shape& shape : outside) boxes.push_back(boundsOf(shape));
        tree = Bvh(boxes, Leaves::leafSize, threads);
        treeBuilt = true;
        boxes = {};
        leaves.assign(std::exchange(outside, std::move(rest)), tree.order(), leafSizes());
    }

    // The sizes of the leaves, in the order of their shapes.
    std::vector<int> leafSizes() const {
        std::vector<int> startingAt(tree.order().size());  // 0: no leaf starts here
        tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) {
            startingAt[first] = static_cast<int>(count);
        });
        std::erase(startingAt, 0);
        return startingAt;
    }

    void dissolveTree() {
        if (!hasTree()) return;
        tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) {
            const int n = static_cast<int>(count);
            for (int i = 0; i < n; ++i) outside.push_back(leaves.shape(first, n, i));
        });
        tree = Bvh();
        leaves = Leaves();
        treeBuilt = false;
    }

    // Tests the shapes of a leaf that the traversal has reached.
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

    std::vector<Shape> outside;  // of the tree
    std::vector<Packet> packets;
    Bvh tree;
    Leaves leaves;
    bool treeBuilt = false;
};

}  // namespace sw
