#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "accel/filterRay.h"
#include "swPrimitive.h"

namespace sw {

/// What a search along a ray finds.
enum class Find { nearest, any, whether };

/// A search along a ray. For the nearest hit, the ray gets shortened to the nearest one so far, and
/// of two shapes hit at the same t the one of lower rank counts.
template <Find what>
class Search {
public:
    static constexpr bool onlyWhether = what == Find::whether;

    /// @param whole   the ray; must outlive the search, and not be part of `record`
    /// @param record  receives the hit, unless the search is only whether there is one
    /// @param order   the rank of each place; beyond its end, places are ranks
    Search(const Ray& whole, Intersection& record, std::span<const std::uint32_t> order)
        : filterRay(whole), whole(whole), rest(&whole), record(record), order(order) {}
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Tests one shape. Returns true if the search is over.
    template <typename Shape>
    bool test(const Shape& shape, std::uint32_t place) {
        if (found) return testForNearer(shape, place);
        record.geometricNormal = Vec3();  // these two, intersect() need not set
        record.positionError = -1;
        if (!isHit(shape, record)) return false;
        shorten(place);
        return what != Find::nearest;
    }
    /// The same for a primitive of which nothing is known.
    bool test(const std::shared_ptr<Primitive>& shape, std::uint32_t place) {
        return testForNearer(*shape, place);
    }

    /// Ends a search that needs no record.
    bool end() { return found = true; }
    bool isFound() const { return found; }

    /// Puts the whole ray into the record. Returns whether there is a hit.
    bool finish() {
        if (found && !onlyWhether) record.ray = whole;
        return found;
    }

    /// What is left of the ray.
    const Ray& ray() const { return *rest; }

    FilterRay filterRay;

private:
    // Uses a record of its own, as a primitive may write into it before it finds that it is missed.
    template <typename Shape>
    bool testForNearer(const Shape& shape, std::uint32_t place) {
        Intersection candidate;
        if (!isHit(shape, candidate) || (found && !isBefore(candidate.hitT, place))) return false;
        record = candidate;
        shorten(place);
        return what != Find::nearest;
    }

    bool isBefore(float t, std::uint32_t place) const {
        return t < record.hitT || (t == record.hitT && rank(place) < rank(recordPlace));
    }
    std::uint32_t rank(std::uint32_t place) const {
        return place < order.size() ? order[place] : place;
    }

    void shorten(std::uint32_t place) {
        found = true;
        if (what != Find::nearest) return;
        recordPlace = place;
        // Copied only now: rays that hit nothing, or stop at the first hit, need no copy. It ends
        // a little behind the hit, for others at the same t.
        shortened = whole;
        shortened.maxT = std::min(whole.maxT, widened(record.hitT));
        rest = &shortened;
        filterRay.shorten(shortened.maxT);
    }

    template <typename Shape>
    bool isHit(const Shape& shape, Intersection& hit) const {
        return shape.Shape::intersect(*rest, hit) && rest->contains(hit.hitT);  // no virtual call
    }
    bool isHit(const Primitive& shape, Intersection& hit) const {
        return shape.intersect(*rest, hit) && rest->contains(hit.hitT);
    }

    const Ray& whole;
    const Ray* rest;
    Ray shortened;
    Intersection& record;
    std::span<const std::uint32_t> order;
    std::uint32_t recordPlace = 0;
    bool found = false;
};

}  // namespace sw
