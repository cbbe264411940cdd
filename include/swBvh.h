#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "swBounds.h"
#include "swBvhNode.h"
#include "swRay.h"

namespace sw {

/// Bounding volume hierarchy: finds the few boxes that a ray can hit. It does not know what the
/// boxes contain. Queries may run in many threads at once.
class Bvh {
public:
    static constexpr int width = BvhNode::width;
    static constexpr int maxDepth = 48;  ///< levels of nodes, whatever the boxes

    /// How many nodes and primitives a traversal has tested.
    struct Cost {
        std::uint64_t nodes = 0, primitives = 0;
    };

    using Node = BvhNode;

    Bvh() = default;

    /// @param boxes     finite, at most 2^28; a primitive's number is its index here
    /// @param leafSize  the most primitives per leaf, 1..8
    /// @param threads   for building; the tree is the same for any number
    /// @param kinds     up to 2^29, one for each box: boxes of two kinds share no leaf
    explicit Bvh(std::span<const Bounds> boxes, int leafSize = 8, int threads = 1,
                 std::span<const std::uint32_t> kinds = {});

    /// The primitives' numbers in tree order: every leaf is a range of this.
    std::span<const std::uint32_t> order() const { return primitives; }
    std::span<const Node> tree() const { return nodes; }  ///< the root comes first
    /// Calls visit(leaf) for every leaf, a range of order().
    template <typename Visit>
    void eachLeaf(const Visit& visit) const {
        for (const Node& node : nodes)
            for (int i = 0; i < width; ++i)
                if (node.hasLeaf(i)) visit(rangeOf(node.child[i]));
    }
    /// Calls number(leaf) for every leaf, in the same order. What that returns, below 2^28, stands
    /// in place of the range's start from now on, and the order is dropped.
    template <typename Number>
    void numberLeaves(const Number& number) {
        for (Node& node : nodes)
            for (int i = 0; i < width; ++i)
                if (node.hasLeaf(i))
                    node.child[i] =
                        Node::leaf(number(rangeOf(node.child[i])), Node::leafCount(node.child[i]));
        primitives = {};
    }

    /// Visits the leaves whose boxes the ray hits with minT < t < maxT, roughly from front to back.
    /// Rounding never makes it miss a true intersection inside a box, for origins up to 2^127.
    /// Where minT < 0, it may visit leaves around the origin twice.
    /// @param leaf  bool(std::uint32_t first, std::uint32_t count, float& limit): tests the
    ///              primitives order()[first .. first + count); for a nearer hit, sets limit to
    ///              its widened() t; true ends the traversal
    /// Defined in bvhTraversal.h.
    template <typename Leaf>
    Cost traverse(const Ray& ray, const Leaf& leaf) const;

private:
    std::span<const std::uint32_t> rangeOf(std::uint32_t leaf) const {
        return order().subspan(Node::leafFirst(leaf), Node::leafCount(leaf));
    }

    std::vector<Node> nodes;
    std::vector<std::uint32_t> primitives;
};

}  // namespace sw
