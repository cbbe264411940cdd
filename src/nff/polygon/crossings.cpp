#include "nff/polygon/crossings.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>

namespace sw {
namespace {

// A side of the polygon, from its lower end (Point2's order) to the higher one.
struct Side {
    Point2 low, high;
};

bool cross(const Side& s, const Side& t) {
    const double a = orientation(s.low, s.high, t.low), b = orientation(s.low, s.high, t.high);
    if (!((a < 0 && b > 0) || (a > 0 && b < 0))) return false;
    const double c = orientation(t.low, t.high, s.low), d = orientation(t.low, t.high, s.high);
    return (c < 0 && d > 0) || (c > 0 && d < 0);
}

// Orders the sides that the sweep line cuts from bottom to top. Where sides coincide, any order
// will do.
struct Below {
    bool operator()(const Side* s, const Side* t) const {
        if (s->low < t->low) {
            const double side = sideOf(*s, *t);
            return side != 0 ? side > 0 : s < t;
        }
        const double side = sideOf(*t, *s);
        return side != 0 ? side < 0 : s < t;
    }

    // Where a side lies whose lower end the sweep line meets later: positive: above the first one.
    static double sideOf(const Side& first, const Side& later) {
        const double begin = orientation(first.low, first.high, later.low);
        return begin != 0 ? begin : orientation(first.low, first.high, later.high);
    }
};

using Cut = std::set<const Side*, Below>;

bool crossesNeighbour(const Cut& cut, Cut::const_iterator side) {
    const auto next = std::next(side);
    return (next != cut.end() && cross(**side, **next)) ||
           (side != cut.begin() && cross(**side, **std::prev(side)));
}

// Where the sweep line meets an end of a side.
struct Event {
    Point2 point;
    std::size_t side;
    bool ends;

    // Sides leave before others enter at the same point.
    bool operator<(const Event& e) const {
        return point == e.point ? ends && !e.ends : point < e.point;
    }
};

std::vector<Side> sidesOf(const std::vector<Point2>& polygon) {
    std::vector<Side> sides;
    sides.reserve(polygon.size());
    Point2 last = polygon.back();
    for (const Point2& p : polygon) {
        if (p != last) sides.push_back(p < last ? Side{p, last} : Side{last, p});
        last = p;
    }
    return sides;
}

std::vector<Event> eventsOf(const std::vector<Side>& sides) {
    std::vector<Event> events;
    events.reserve(2 * sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        events.push_back({sides[i].low, i, false});
        events.push_back({sides[i].high, i, true});
    }
    std::sort(events.begin(), events.end());
    return events;
}

}  // namespace

bool hasCrossings(const std::vector<Point2>& polygon) {
    const std::vector<Side> sides = sidesOf(polygon);
    Cut cut;
    std::vector<Cut::iterator> place(sides.size());
    for (const Event& event : eventsOf(sides)) {
        auto& here = place[event.side];
        if (event.ends) {
            const auto above = cut.erase(here);
            if (above != cut.end() && crossesNeighbour(cut, above)) return true;
        } else {
            here = cut.insert(&sides[event.side]).first;
            if (crossesNeighbour(cut, here)) return true;
        }
    }
    return false;
}

}  // namespace sw
