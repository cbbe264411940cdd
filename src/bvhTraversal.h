#pragma once

// How a ray finds its way through a Bvh. A header because the leaf test is compiled into the loop.
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
// A direction of +-0 has an infinite reciprocal: the products are +-inf, or NaN for an origin in
// the plane. min() and max() below then return their second operand: the plane excludes nothing.
// If the reciprocal of a denormal overflows, the entry uses FLT_MAX in its place (too early), the
// exit infinity (too late). Directions beyond 2^126 have a less accurate reciprocal; no proof
// there.
//
// Where minT < 0, t may be negative and a factor would work the wrong way: there the exit gets
// |exit| margin added after the products, and FLT_MIN against underflow; the axis of an overflowed
// reciprocal excludes nothing.

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "simd.h"
#include "swBvh.h"

namespace sw {
namespace {  // programs and library may be compiled for different machines: no symbols to share

constexpr float slabMargin = 0x1p-20f;

/// A little more than t: for comparisons with distances to boxes.
inline float widened(float t) {
    return t + std::fabs(t) * slabMargin;
}

/// A ray, prepared for being tested against eight boxes at a time.
/// @tparam behind  whether minT is negative
template <bool behind>
class RaySlabs {
public:
    explicit RaySlabs(const Ray& ray) : minT(simd::broadcast(ray.minT)) {
        for (int i = 0; i < 3; ++i) {
            const float d = ray.dir.m[i];
            float entry = 1 / d, exit = behind ? entry : entry * (1 + slabMargin);
            if (std::fabs(entry) > FLT_MAX && d != 0) {
                entry = behind ? NAN : std::copysign(FLT_MAX, d);
                if (behind) exit = NAN;
            }
            origin[i] = simd::broadcast(ray.orig.m[i]);
            entryInverse[i] = simd::broadcast(entry);
            exitInverse[i] = simd::broadcast(exit);
            entryPlane[i] = (std::signbit(d) ? i + 3 : i) * Bvh::width;
            exitPlane[i] = (std::signbit(d) ? i : i + 3) * Bvh::width;
        }
    }

    /// @param limit   an upper bound for t, widened
    /// @param entry   receives where the ray enters each box
    /// @return        one bit for each of the boxes that it meets
    unsigned meets(const Bvh::Node& node, const simd::Float& limit, simd::Float& entry) const {
        const float* planes = node.planes[0];
        simd::Float exit = limit;
        entry = minT;
        for (int i = 0; i < 3; ++i) {
            const simd::Float enter = simd::load(planes + entryPlane[i]) - origin[i];
            const simd::Float leave = simd::load(planes + exitPlane[i]) - origin[i];
            entry = simd::max(enter * entryInverse[i], entry);
            exit = simd::min(leave * exitInverse[i], exit);
        }
        if constexpr (behind)
            exit =
                exit + (simd::abs(exit) * simd::broadcast(slabMargin) + simd::broadcast(FLT_MIN));
        return simd::bits(entry <= exit);
    }

private:
    simd::Float origin[3], entryInverse[3], exitInverse[3], minT;
    std::ptrdiff_t entryPlane[3], exitPlane[3];
};

/// Asks for a node that will be visited soon: beyond a million primitives most of the time is spent
/// waiting for memory.
inline void prefetch([[maybe_unused]] const Bvh::Node* nodes,
                     [[maybe_unused]] std::uint32_t child) {
#ifdef __GNUC__
    if (Bvh::isLeaf(child)) return;
    const char* line = reinterpret_cast<const char*>(nodes + child);
    for (std::size_t i = 0; i < sizeof(Bvh::Node); i += 64) __builtin_prefetch(line + i);
#endif
}

/// Children still to be visited. Every level of the tree leaves at most seven of them here.
class TraversalStack {
public:
    bool empty() const { return size == 0; }

    /// Takes the top entry off.
    /// @param distance  receives where the ray enters its box
    std::uint32_t pop(float& distance) {
        --size;
        distance = entries[size].distance;
        return entries[size].child;
    }

    /// Picks one of two or more children that are hit and keeps the others for later; with
    /// `sorted` the nearest.
    template <bool sorted>
    std::uint32_t push(const Bvh::Node& node, const Bvh::Node* nodes, unsigned hits,
                       const simd::Float& entry) {
        float distance[simd::lanes];
        std::memcpy(distance, &entry, sizeof distance);
        const auto next = [&] {
            const int slot = std::countr_zero(hits);
            hits &= hits - 1;
            return Entry{node.child[slot], distance[slot]};
        };
        Entry nearest = next();
        [[maybe_unused]] const int bottom = size;
        do {
            Entry e = next();
            prefetch(nodes, e.child);
            if constexpr (sorted) {
                if (e.distance < nearest.distance) std::swap(e, nearest);
                insert(e, bottom);
            } else {
                entries[size++] = e;
            }
        } while (hits != 0);
        return nearest.child;
    }

private:
    struct Entry {
        std::uint32_t child;
        float distance;
    };

    // Keeps the entries from bottom upwards sorted, the nearest on top.
    void insert(const Entry& e, int bottom) {
        int place = size++;
        for (; place > bottom && entries[place - 1].distance < e.distance; --place)
            entries[place] = entries[place - 1];
        entries[place] = e;
    }

    Entry entries[(Bvh::width - 1) * Bvh::maxDepth + 1];
    int size = 0;
};

template <bool sorted, bool behind, typename Leaf>
Bvh::Cost traverse(const Bvh::Node* nodes, const Ray& ray, Leaf& leaf) {
    const RaySlabs<behind> slabs(ray);
    TraversalStack stack;
    Bvh::Cost cost;
    float maxT = ray.maxT;
    float limit = widened(maxT);
    std::uint32_t child = 0;
    for (;;) {
        if (!Bvh::isLeaf(child)) {
            const Bvh::Node& node = nodes[child];
            ++cost.nodes;
            simd::Float entry;
            const unsigned hits = slabs.meets(node, simd::broadcast(limit), entry);
            if (std::has_single_bit(hits)) {
                child = node.child[std::countr_zero(hits)];
                continue;
            }
            if (hits != 0) {
                child = stack.push<sorted>(node, nodes, hits, entry);
                continue;
            }
        } else {
            cost.primitives += Bvh::leafCount(child);
            if (leaf(Bvh::leafFirst(child), Bvh::leafCount(child), maxT)) return cost;
            limit = widened(maxT);
        }
        float distance;
        do {
            if (stack.empty()) return cost;
            child = stack.pop(distance);
        } while (distance > limit);
    }
}

template <bool sorted, typename Leaf>
Bvh::Cost traverse(std::span<const Bvh::Node> nodes, const Ray& ray, Leaf& leaf) {
    float sum = 0;  // NaN if a coordinate is infinite or NaN: such a ray meets nothing
    for (int i = 0; i < 3; ++i) sum += 0 * ray.orig.m[i] + 0 * ray.dir.m[i];
    if (nodes.empty() || sum != 0 || !(ray.minT < ray.maxT)) return {};
    if (ray.minT < 0) return traverse<sorted, true>(nodes.data(), ray, leaf);
    return traverse<sorted, false>(nodes.data(), ray, leaf);
}

}  // namespace

template <typename Leaf>
Bvh::Cost Bvh::closest(const Ray& ray, Leaf&& leaf) const {
    return traverse<true>(tree(), ray, leaf);
}

template <typename Leaf>
Bvh::Cost Bvh::any(const Ray& ray, Leaf&& leaf) const {
    return traverse<false>(tree(), ray, leaf);
}

}  // namespace sw
