#pragma once

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <vector>

#include "bvhTraversal.h"
#include "shapeFilter.h"
#include "simd.h"

namespace sw {

/// Looks for hits along one ray, and shortens it to the nearest one so far.
class Search {
public:
    Search(const Ray& asked, Intersection& result, bool anyHit)
        : filterRay(asked), any(anyHit), end(asked.maxT), rest(asked), nearest(result) {}

    /// Tests one shape. Returns whether the search is over.
    template <typename Shape>
    bool test(const Shape& shape) {
        // A record of its own: a primitive may scribble into it before it knows that it is missed,
        // and may leave positionError unstated.
        Intersection candidate;
        if (!intersect(shape, candidate)) return false;
        if (!(rest.minT < candidate.hitT && candidate.hitT < rest.maxT)) return false;  // or NaN
        found = true;
        nearest = candidate;
        rest.maxT = nearest.hitT;
        filterRay.shorten(nearest.hitT);
        return any;
    }

    /// Makes the record name the ray as it was asked. That may have been the record's own ray,
    /// which the hits have overwritten since.
    void finish() {
        nearest.ray = rest;
        nearest.ray.maxT = end;
    }

    /// What is left of the ray.
    const Ray& ray() const { return rest; }

    FilterRay filterRay;
    bool found = false;
    const bool any;

private:
    template <typename Shape>
    bool intersect(const Shape& shape, Intersection& candidate) const {
        return shape.Shape::intersect(rest, candidate);  // known type: no virtual call
    }
    bool intersect(const std::shared_ptr<Primitive>& shape, Intersection& candidate) const {
        return shape->intersect(rest, candidate);
    }

    const float end;
    Ray rest;
    Intersection& nearest;
};

/// Lets every shape through: for primitives that nothing is known about.
class NoFilter {
public:
    template <typename Shapes>
    void assign(const Shapes&, std::span<const int>) {}
    unsigned candidates(const FilterRay&, std::size_t, int count) const {
        return (1u << count) - 1;
    }
};

/// All shapes of one type, neighbours in memory and behind their filter. A few are looked at block
/// by block; many stand in a tree, whose leaves are the blocks.
template <typename Shape, typename Filter>
class ShapeSet {
public:
    void push(Shape shape) { shapes.push_back(std::move(shape)); }

    /// Must be called between the last push and the first search.
    void prepare(int threads) {
        const auto unbounded = std::stable_partition(
            shapes.begin(), shapes.end(), [](const Shape& s) { return boundsOf(s).isFinite(); });
        inTree = static_cast<std::size_t>(unbounded - shapes.begin());
        if (inTree <= fewShapes) inTree = 0;
        tree = Bvh();
        if (inTree > 0) growTree(threads);
        filter.assign(shapes, blockSizes());
    }

    /// Returns whether the search is over.
    bool find(Search& search) const {
        if (inTree > 0 && findInTree(search)) return true;
        for (std::size_t first = inTree; first < shapes.size(); first += simd::lanes)
            if (testBlock(search, first, flatBlockSize(first))) return true;
        return false;
    }

private:
    // Up to about this many, looking at all shapes takes no longer than finding a way among them.
    // Measured on scattered shapes: 32 for triangles, 48 to 64 for spheres.
    static constexpr std::size_t fewShapes = 32;

    static Bounds boundsOf(const Primitive& shape) { return shape.bounds(); }
    static Bounds boundsOf(const std::shared_ptr<Primitive>& shape) { return shape->bounds(); }

    void growTree(int threads) {
        std::vector<Bounds> boxes;
        boxes.reserve(inTree);
        for (std::size_t i = 0; i < inTree; ++i) boxes.push_back(boundsOf(shapes[i]));
        tree = Bvh(boxes, simd::lanes, threads);
        std::vector<Shape> sorted;
        sorted.reserve(shapes.size());
        for (const std::uint32_t i : tree.order()) sorted.push_back(std::move(shapes[i]));
        for (std::size_t i = inTree; i < shapes.size(); ++i) sorted.push_back(std::move(shapes[i]));
        shapes = std::move(sorted);
    }

    int flatBlockSize(std::size_t first) const {
        return static_cast<int>(std::min<std::size_t>(shapes.size() - first, simd::lanes));
    }

    // First the leaves, in the order of their shapes, then what stands outside of the tree.
    std::vector<int> blockSizes() const {
        std::vector<int> startingAt(inTree);  // leaf sizes; 0: no leaf starts here
        for (const Bvh::Node& node : tree.tree())
            for (int i = 0; i < Bvh::width; ++i)
                if (Bvh::isLeaf(node.child[i]) && node.planes[0][i] <= node.planes[3][i])
                    startingAt[Bvh::leafFirst(node.child[i])] =
                        static_cast<int>(Bvh::leafCount(node.child[i]));
        std::erase(startingAt, 0);
        for (std::size_t first = inTree; first < shapes.size(); first += simd::lanes)
            startingAt.push_back(flatBlockSize(first));
        return startingAt;
    }

    bool findInTree(Search& search) const {
        bool over = false;
        const auto leaf = [&](std::uint32_t first, std::uint32_t count, float& maxT) {
            over = testBlock(search, first, static_cast<int>(count));
            maxT = search.ray().maxT;
            return over;
        };
        search.any ? tree.any(search.ray(), leaf) : tree.closest(search.ray(), leaf);
        return over;
    }

    bool testBlock(Search& search, std::size_t first, int count) const {
        unsigned candidates = filter.candidates(search.filterRay, first, count);
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(candidates));
            if (search.test(shapes[first + i])) return true;
        }
        return false;
    }

    std::vector<Shape> shapes;  // those in the tree first, in its order
    std::size_t inTree = 0;
    Bvh tree;
    Filter filter;
};

}  // namespace sw
