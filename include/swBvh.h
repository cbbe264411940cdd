#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "swBounds.h"
#include "swRay.h"

namespace sw {

/// Bounding volume hierarchy: boxes in, and out come the few that a ray can meet. Knows nothing of
/// what is inside the boxes. Queries may run in many threads at once.
class Bvh {
public:
    static constexpr int width = 8;      ///< children of a node
    static constexpr int maxDepth = 48;  ///< levels of nodes, whatever the boxes

    /// What a traversal has looked at.
    struct Cost {
        std::uint64_t nodes = 0, primitives = 0;
    };

    /// 256 bytes: four cache lines.
    struct alignas(64) Node {
        float planes[6][width];      ///< min x, y, z, max x, y, z of every child; empty: inf, -inf
        std::uint32_t child[width];  ///< see isLeaf()
        /// For every octant of directions (bit i: component i is negative) the children from the
        /// farthest to the nearest, three bits each.
        std::uint32_t order[width];
    };

    Bvh() = default;

    /// @param boxes     finite, at most 2^28; the primitives are known by their numbers in here
    /// @param leafSize  most primitives per leaf, 1..8
    /// @param threads   to build with; the tree is the same for any number
    explicit Bvh(std::span<const Bounds> boxes, int leafSize = 8, int threads = 1);

    /// The numbers of the primitives in the order of the tree: every leaf is a range of this.
    std::span<const std::uint32_t> order() const { return primitives; }
    std::span<const Node> tree() const { return nodes; }  ///< the root comes first
    /// Calls visit(std::uint32_t first, std::uint32_t count) for every leaf: a range of order().
    template <typename Visit>
    void eachLeaf(const Visit& visit) const {
        for (const Node& node : nodes)
            for (int i = 0; i < width; ++i)
                if (isLeaf(node.child[i]) && node.planes[0][i] <= node.planes[3][i])
                    visit(leafFirst(node.child[i]), leafCount(node.child[i]));
    }

    Bounds bounds() const;      ///< of everything; empty if there is nothing
    std::size_t bytes() const;  ///< memory for nodes and order()

    /// Visits, roughly from front to back, the leaves whose boxes the ray meets with
    /// minT < t < maxT. No true intersection inside a box is missed by rounding, for origins up to
    /// 2^127.
    /// @param leaf  bool(std::uint32_t first, std::uint32_t count, float& maxT): tests the
    ///              primitives order()[first .. first + count), sets maxT to a nearer hit's t;
    ///              true ends the traversal. If it has a prefetch(first, count) const, that is told
    ///              of leaves that may be visited soon.
    /// Defined in bvhTraversal.h.
    template <typename Leaf>
    Cost traverse(const Ray& ray, Leaf&& leaf) const;

    // A child is a node's index, or the range of a leaf: its first place in order() and its size.
    static constexpr std::uint32_t leafBit = 1u << 31;
    static constexpr int sizeShift = 28;
    static bool isLeaf(std::uint32_t child) { return (child & leafBit) != 0; }
    static std::uint32_t leafFirst(std::uint32_t child) { return child & ((1u << sizeShift) - 1); }
    static std::uint32_t leafCount(std::uint32_t child) { return ((child >> sizeShift) & 7) + 1; }

private:
    std::vector<Node> nodes;
    std::vector<std::uint32_t> primitives;
};

}  // namespace sw
