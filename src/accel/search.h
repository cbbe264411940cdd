#pragma once

#include <memory>

#include "accel/filterRay.h"
#include "swPrimitive.h"

namespace sw {

/// Looks for hits along one ray, and shortens it to the nearest one so far.
class Search {
public:
    /// @param asked  must outlive the search, and not be part of the result
    Search(const Ray& asked, Intersection& result, bool anyHit)
        : filterRay(asked), any(anyHit), whole(asked), rest(&asked), nearest(result) {}
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Tests one shape. Returns whether the search is over.
    template <typename Shape>
    bool test(const Shape& shape) {
        if (found) return testForNearer(shape);
        nearest = Intersection();
        if (!intersect(shape, nearest) || !counts(nearest.hitT)) return false;
        shorten();
        return any;
    }

    /// The same for a primitive of which nothing is known.
    bool test(const std::shared_ptr<Primitive>& shape) { return testForNearer(*shape); }

    /// Makes the record name the ray as it was asked.
    void finish() { nearest.ray = whole; }

    /// What is left of the ray.
    const Ray& ray() const { return *rest; }

    FilterRay filterRay;
    bool found = false;
    const bool any;

private:
    // With a record of its own: a primitive may scribble into it before it knows that it is missed.
    template <typename Shape>
    bool testForNearer(const Shape& shape) {
        Intersection candidate;
        if (!intersect(shape, candidate) || !counts(candidate.hitT)) return false;
        nearest = candidate;
        shorten();
        return any;
    }

    bool counts(float t) const { return rest->minT < t && t < rest->maxT; }  // false for NaN

    void shorten() {
        found = true;
        if (any) return;
        // Copied only now, as rays that hit nothing, or end at their first hit, never need it.
        shortened = whole;
        shortened.maxT = nearest.hitT;
        rest = &shortened;
        filterRay.shorten(nearest.hitT);
    }

    template <typename Shape>
    bool intersect(const Shape& shape, Intersection& record) const {
        return shape.Shape::intersect(*rest, record);  // known type: no virtual call
    }
    bool intersect(const Primitive& shape, Intersection& record) const {
        return shape.intersect(*rest, record);
    }

    const Ray& whole;
    const Ray* rest;
    Ray shortened;
    Intersection& nearest;
};

}  // namespace sw
