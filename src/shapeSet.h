#pragma once

#include <bit>
#include <memory>
#include <vector>

#include "shapeFilter.h"
#include "simd.h"

namespace sw {

/// Looks for hits along one ray, and shortens it to the nearest one so far.
class Search {
public:
    Search(const Ray& ray, Intersection& result, bool anyHit)
        : filterRay(ray), any(anyHit), end(ray.maxT), rest(ray), nearest(result) {}

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

    /// Makes the record name the ray as it was asked. That may have been the record's own ray, which
    /// the hits have overwritten since.
    void finish() {
        nearest.ray = rest;
        nearest.ray.maxT = end;
    }

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

/// All shapes of one type, neighbours in memory, behind their filter.
template <typename Shape, typename Filter>
class ShapeSet {
public:
    void push(const Shape& shape) { shapes.push_back(shape); }

    /// Must be called between the last push and the first search.
    void prepare() {
        blocks.assign(shapes.size() / simd::lanes, simd::lanes);
        if (const auto rest = shapes.size() % simd::lanes) blocks.push_back(static_cast<int>(rest));
        filter.assign(shapes, blocks);
    }

    /// Returns whether the search is over.
    bool find(Search& search) const {
        std::size_t first = 0;
        for (const int count : blocks) {
            if (testBlock(search, first, count)) return true;
            first += static_cast<std::size_t>(count);
        }
        return false;
    }

private:
    bool testBlock(Search& search, std::size_t first, int count) const {
        unsigned candidates = filter.candidates(search.filterRay, first, count);
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(candidates));
            if (search.test(shapes[first + i])) return true;
        }
        return false;
    }

    std::vector<Shape> shapes;
    std::vector<int> blocks;
    Filter filter;
};

}  // namespace sw
