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
    using Run = BvhRun;

    Bvh() = default;

    /// @param boxes    finite, at most 2^28; a primitive's number is its index here
    /// @param runs     what the boxes consist of, run by run. No leaf holds primitives of two runs;
    ///                 in order() the leaves of each run stand together, run after run.
    /// @param threads  for building; the tree is the same for any number
    Bvh(std::span<const Bounds> boxes, std::span<const Run> runs, int threads = 1);
    /// The same with a single run.
    explicit Bvh(std::span<const Bounds> boxes, int leafSize = 8, int threads = 1);

    /// The primitives' numbers in tree order: every leaf is a range of this.
    std::span<const std::uint32_t> order() const { return primitives; }
    std::span<const Node> tree() const { return nodes; }  ///< the root comes first
    /// Calls visit(std::uint32_t first, std::uint32_t count) for every leaf: a range of order().
    template <typename Visit>
    void eachLeaf(const Visit& visit) const {
        for (const Node& node : nodes)
            for (int i = 0; i < width; ++i)
                if (Node::isLeaf(node.child[i]) && node.planes[0][i] <= node.planes[3][i])
                    visit(Node::leafFirst(node.child[i]), Node::leafCount(node.child[i]));
    }

    /// Visits the leaves whose boxes the ray hits with minT < t < maxT, roughly from front to back.
    /// Rounding never makes it miss a true intersection inside a box, for origins up to 2^127.
    /// @param leaf  bool(std::uint32_t first, std::uint32_t count, float& maxT): tests the
    ///              primitives order()[first .. first + count), sets maxT to a nearer hit's t;
    ///              true ends the traversal
    /// Defined in bvhTraversal.h.
    template <typename Leaf>
    Cost traverse(const Ray& ray, Leaf&& leaf) const;

private:
    std::vector<Node> nodes;
    std::vector<std::uint32_t> primitives;
};

}  // namespace sw
