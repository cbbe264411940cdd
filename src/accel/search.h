#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "accel/filterRay.h"
#include "swPrimitive.h"

namespace sw {

/// What a search along a ray finds.
enum class Find { nearest, any, whether };

/// A search along a ray. For the nearest hit, the ray gets shortened to the nearest one so far, and
/// of two shapes hit at the same t the one of lower number counts.
template <Find what>
class Search {
public:
    /// @param whole   the ray; must outlive the search, and not be part of `record`
    /// @param record  receives the hit, unless the search is only whether there is one
    Search(const Ray& whole, Intersection& record)
        : filterRay(whole),
          limit(widened(whole.maxT)),
          whole(whole),
          rest(&whole),
          record(record) {}
    Search(const Search&) = delete;
    Search& operator=(const Search&) = delete;

    /// Tests one shape. Returns true if the search is over.
    template <typename Shape>
    bool test(const Shape& shape, std::uint32_t number) {
        if (found) return testForNearer(shape, number);
        record.geometricNormal = Vec3();  // these two, intersect() need not set
        record.positionError = -1;
        if (!isHit(shape, record)) return false;
        shorten(number);
        return what != Find::nearest;
    }
    /// The same for a primitive of which nothing is known.
    bool test(const std::shared_ptr<Primitive>& shape, std::uint32_t number) {
        return testForNearer(*shape, number);
    }

    /// Ends a search that needs no record.
    bool end() { return found = true; }
    bool isOver() const { return found && what != Find::nearest; }

    /// Puts the whole ray into the record. Returns whether there is a hit.
    bool finish() {
        if (found && what != Find::whether) record.ray = whole;
        return found;
    }

    FilterRay filterRay;
    float limit;  ///< a little more than the t of any hit that still counts

private:
    // Uses a record of its own, as a primitive may write into it before it finds that it is missed.
    template <typename Shape>
    bool testForNearer(const Shape& shape, std::uint32_t number) {
        Intersection candidate;
        if (!isHit(shape, candidate) || (found && !isBefore(candidate.hitT, number))) return false;
        record = candidate;
        shorten(number);
        return what != Find::nearest;
    }

    bool isBefore(float t, std::uint32_t number) const {
        return t < record.hitT || (t == record.hitT && number < recordNumber);
    }

    void shorten(std::uint32_t number) {
        found = true;
        if (what != Find::nearest) return;
        recordNumber = number;
        limit = widened(record.hitT);
        // Copied only now: rays that hit nothing, or stop at the first hit, need no copy. It ends
        // a little behind the hit, for others at the same t.
        shortened = whole;
        shortened.maxT = std::min(whole.maxT, limit);
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
    std::uint32_t recordNumber = 0;
    bool found = false;
};

}  // namespace sw
