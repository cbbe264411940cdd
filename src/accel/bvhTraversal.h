#pragma once

// The traversal of a Bvh. It is a header so that the leaf test is compiled into the loop.
//
// No box that a ray truly meets may be missed by rounding (Ize, Robust BVH Ray Traversal, JCGT
// 2013). The entry into the slab between two planes is computed as (plane - origin) * (1 / dir):
// three roundings, each by a factor within 1 +- u, u = 2^-24; so is the exit. (The form
// plane * inv - origin * inv saves an operation where there is FMA, but its error grows with the
// origin's distance: nearby it would cost boxes 4u |origin| thick, or a miss.) A point at t >= 0
// inside a box has
//     entry <= t (1 + u)^3   and   exit >= t (1 - u)^3 (1 - u) (1 + margin) >= t (1 + 8u)
// if the exit's reciprocal is enlarged by margin = 16u, with one more rounding. Hence entry <= exit
// for every pair of axes, exit > minT, and entry < maxT (1 + margin) even if t was rounded to
// float before it was compared with maxT. The last product is rounded monotonically, so that all
// of this holds when it underflows.
//
// The reciprocal of a direction of 0 or of a small denormal overflows: the entry uses +-FLT_MAX in
// its place (too early), the exit infinity (too late). For an origin in the plane the exit is NaN:
// min() and max() below then return their second operand, and the plane excludes nothing.
// Directions beyond 2^126 have a less accurate reciprocal; no proof there.

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "accel/filterRay.h"
#include "accel/simd.h"
#include "swBvh.h"

namespace sw {
namespace {  // programs and library may be compiled for different machines: no symbols to share

constexpr float slabMargin = 0x1p-20f;

/// A ray prepared for tests against eight boxes at a time.
class RaySlabs {
public:
    explicit RaySlabs(const Ray& ray) : minT(simd::broadcast(std::max(ray.minT, 0.0f))) {
        for (int i = 0; i < 3; ++i) {
            const float d = ray.dir.m[i], inverse = 1 / d;
            const bool tooLarge = std::fabs(inverse) > FLT_MAX;
            const float entry = tooLarge ? std::copysign(FLT_MAX, d) : inverse;
            origin[i] = simd::broadcast(ray.orig.m[i]);
            entryInverse[i] = simd::broadcast(entry);
            exitInverse[i] = simd::broadcast(entry * (1 + slabMargin));
            entryPlane[i] = (std::signbit(d) ? i + 3 : i) * Bvh::width;
            exitPlane[i] = (std::signbit(d) ? i : i + 3) * Bvh::width;
            octant |= (std::signbit(d) ? 1u : 0u) << i;
        }
    }

    /// @param limit   an upper bound for t, widened
    /// @param entry   receives where the ray enters each box
    /// @return        which of the boxes it meets
    simd::Mask meets(const Bvh::Node& node, const simd::Float& limit, simd::Float& entry) const {
        const float* planes = node.planes[0];
        simd::Float exit = limit;
        entry = minT;
        for (int i = 0; i < 3; ++i) {
            const simd::Float enter = simd::load(planes + entryPlane[i]) - origin[i];
            const simd::Float leave = simd::load(planes + exitPlane[i]) - origin[i];
            entry = simd::max(enter * entryInverse[i], entry);
            exit = simd::min(leave * exitInverse[i], exit);
        }
        return entry <= exit;
    }

    unsigned octant = 0;  ///< of the direction: bit i is set where component i is negative

private:
    simd::Float origin[3], entryInverse[3], exitInverse[3], minT;
    std::ptrdiff_t entryPlane[3], exitPlane[3];
};

/// For every set of eight bits: the numbers of the bits that are set, three bits each.
inline constexpr auto bitNumbers = [] {
    std::array<std::uint32_t, 1u << Bvh::width> table{};
    for (unsigned set = 0; set < table.size(); ++set)
        for (unsigned bit = 0, n = 0; bit < Bvh::width; ++bit)
            if ((set >> bit & 1) != 0) table[set] |= bit << 3 * n++;
    return table;
}();

/// The children still to be visited, the next one on top. Every level of the tree leaves at most
/// seven.
class TraversalStack {
public:
    bool empty() const { return size == 0; }
    std::uint32_t top() const { return children[size - 1]; }

    /// Takes the top entry off.
    /// @param distance  receives where the ray enters its box
    std::uint32_t pop(float& distance) {
        --size;
        distance = distances[size];
        return children[size];
    }

    /// Pushes all children that are hit but the nearest, in the given order, and returns the
    /// nearest. Without branches, as these would be unpredictable.
    std::uint32_t push(const Bvh::Node& node, std::uint32_t order, const simd::Mask& hit,
                       const simd::Float& entry) {
#ifdef SW_SIMD_PERMUTE
        const simd::Mask inOrder = simd::unpackNumbers(order);
        const unsigned hits = simd::bits(simd::permute(hit, inOrder));
        const simd::Mask chosen = simd::permute(inOrder, simd::unpackNumbers(bitNumbers[hits]));
        simd::Mask child;
        std::memcpy(&child, node.child, sizeof child);
        const simd::Mask sortedChildren = simd::permute(child, chosen);
        const simd::Float sortedDistances = simd::permute(entry, chosen);
        std::memcpy(children + size, &sortedChildren, sizeof sortedChildren);
        std::memcpy(distances + size, &sortedDistances, sizeof sortedDistances);
        size += std::popcount(hits) - 1;
        // Not children[size]: it would have to be read back.
        return node.child[order >> 3 * (31 - std::countl_zero(hits)) & 7];
#else
        float distance[simd::lanes];
        std::memcpy(distance, &entry, sizeof distance);
        const unsigned hits = simd::bits(hit);
        for (int i = 0; i < Bvh::width; ++i, order >>= 3) {
            children[size] = node.child[order & 7];
            distances[size] = distance[order & 7];
            size += static_cast<int>(hits >> (order & 7) & 1);
        }
        return children[--size];
#endif
    }

private:
    // Eight entries are written at a time.
    static constexpr int capacity = (Bvh::width - 1) * Bvh::maxDepth + 1 + Bvh::width;
    std::uint32_t children[capacity];
    float distances[capacity];
    int size = 0;
};

/// Whether origin and direction have no infinite or NaN coordinate: else the ray meets nothing.
inline bool isFinite(const Ray& ray) {
    static_assert(offsetof(Ray, dir) == 12 && offsetof(Ray, maxT) == 28);
    simd::Float numbers;  // origin, direction, minT, maxT
    std::memcpy(&numbers, &ray, sizeof numbers);
    const simd::Float zero = numbers * 0;
    return (simd::bits(zero <= zero) & 0x3f) == 0x3f;
}

// Visits what the ray reaches between t = max(0, minT) and the limit, an upper bound, widened.
template <typename Leaf>
SW_INLINE void traverseForwards(const Bvh::Node* nodes, const Ray& ray, float limit,
                                Bvh::Cost& cost, const Leaf& leaf) {
    const RaySlabs slabs(ray);
    TraversalStack stack;
    std::uint32_t child = 0;
    for (;;) {
        if (!BvhNode::isLeaf(child)) {
            const Bvh::Node& node = nodes[child];
            ++cost.nodes;
            simd::Float entry;
            const simd::Mask hit = slabs.meets(node, simd::broadcast(limit), entry);
            const unsigned hits = simd::bits(hit);
            if (std::has_single_bit(hits)) {
                child = node.child[std::countr_zero(hits)];
                continue;
            }
            if (hits != 0) {
                child = stack.push(node, node.order[slabs.octant], hit, entry);
                // In large scenes, most time goes into waiting for memory.
                if (!BvhNode::isLeaf(stack.top())) simd::prefetch(nodes + stack.top(), sizeof node);
                continue;
            }
        } else {
            cost.primitives += BvhNode::leafCount(child);
            if (leaf(BvhNode::leafFirst(child), BvhNode::leafCount(child), limit)) return;
        }
        float distance;
        do {
            if (stack.empty()) return;
            child = stack.pop(distance);
        } while (distance > limit);
    }
}

// Visits all that lies behind the origin: any of it may have the lowest t. Returns whether the
// traversal is over.
template <typename Leaf>
SW_APART bool traverseBackwards(const Bvh::Node* nodes, const Ray& ray, float& limit,
                                Bvh::Cost& cost, const Leaf& leaf) {
    bool isOver = false;
    const auto leafBehind = [&](std::uint32_t first, std::uint32_t count, float&) {
        return isOver = leaf(first, count, limit);
    };
    const Ray back(ray.orig, ray.dir * -1.0f);
    traverseForwards(nodes, back, widened(-ray.minT), cost, leafBehind);
    return isOver;
}

}  // namespace

template <typename Leaf>
SW_INLINE Bvh::Cost Bvh::traverse(const Ray& ray, const Leaf& leaf) const {
    Cost cost;
    if (nodes.empty() || !isFinite(ray) || !(ray.minT < ray.maxT)) return cost;
    float limit = widened(ray.maxT);
    if (ray.minT < 0 && traverseBackwards(nodes.data(), ray, limit, cost, leaf)) return cost;
    traverseForwards(nodes.data(), ray, limit, cost, leaf);
    return cost;
}

}  // namespace sw
