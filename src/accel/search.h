#pragma once

#include <memory>

#include "accel/filterRay.h"
#include "swPrimitive.h"

namespace sw {

/// A search for hits along one ray, which gets shortened to the nearest hit so far.
class Search {
public:
    /// @param whole    the ray; must outlive the search, and not be part of `nearest`
    /// @param nearest  receives the nearest hit, or with `any` the first one found
    Search(const Ray& whole, Intersection& nearest, bool any)
        : filterRay(whole), any(any), whole(whole), rest(&whole), nearest(nearest) {}
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Tests one shape. Returns true if the search is over.
    template <typename Shape>
    bool test(const Shape& shape) {
        if (found) return testForNearer(shape);
        nearest = Intersection();
        if (!intersect(shape, nearest) || !rest->contains(nearest.hitT)) return false;
        shorten();
        return any;
    }

    /// The same for a primitive of which nothing is known.
    bool test(const std::shared_ptr<Primitive>& shape) { return testForNearer(*shape); }

    /// Puts the whole ray into the record.
    void finish() { nearest.ray = whole; }

    /// What is left of the ray.
    const Ray& ray() const { return *rest; }

    FilterRay filterRay;
    bool found = false;
    const bool any;

private:
    // Uses a record of its own, as a primitive may write into it before it finds that it is missed.
    template <typename Shape>
    bool testForNearer(const Shape& shape) {
        Intersection candidate;
        if (!intersect(shape, candidate) || !rest->contains(candidate.hitT)) return false;
        nearest = candidate;
        shorten();
        return any;
    }

    void shorten() {
        found = true;
        if (any) return;
        // Copied only now: rays that hit nothing, or stop at the first hit, need no copy.
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
