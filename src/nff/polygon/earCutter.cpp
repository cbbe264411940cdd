#include "nff/polygon/earCutter.h"

#include <algorithm>
#include <deque>

namespace sw {
namespace {

// Whether corner x, with neighbours `before` and `after`, prevents triangle t from being an ear.
// The ear would be cut off along t's first side.
bool blocks(const Point2 (&t)[3], const Point2& x, const Point2& before, const Point2& after) {
    bool isOn[3];
    for (int i = 0; i < 3; ++i) {
        const double side = orientation(t[i], t[(i + 1) % 3], x);
        if (side < 0) return false;
        isOn[i] = side == 0;
    }
    // Inside, or on the cut. A corner on the cut would lie on an edge of two triangles.
    if (!isOn[1] && !isOn[2]) return true;
    // On another side or at a corner, x only touches t, unless the polygon continues inside.
    const auto leadsInside = [&](const Point2& to) {
        for (int i = 0; i < 3; ++i)
            if (isOn[i] && !(orientation(t[i], t[(i + 1) % 3], to) > 0)) return false;
        return true;
    };
    return leadsInside(before) || leadsInside(after);
}

// Cutting an ear changes only its two neighbours, so each cut adds two candidates for the next ear.
// Only non-convex corners can block an ear. So n corners take at most 3 n^2 steps.
class EarCutter {
public:
    EarCutter(const std::vector<Point2>& corners, Triangulation& result)
        : points(corners),
          out(result),
          previous(corners.size()),
          next(corners.size()),
          isBlocker(corners.size()),
          left(corners.size()) {
        const auto count = static_cast<std::uint32_t>(left);
        for (std::uint32_t i = 0; i < count; ++i) {
            previous[i] = (i == 0 ? count : i) - 1;
            next[i] = i + 1 == count ? 0 : i + 1;
        }
        for (std::uint32_t i = 0; i < count; ++i) review(i);
    }

    void cutAll() {
        while (left >= 3) {
            if (candidates.empty()) forceCut();
            const std::uint32_t corner = candidates.front();
            candidates.pop_front();
            if (isGone(corner)) continue;
            if (isSpike(corner))
                drop(corner);
            else if (isEar(corner))
                cut(corner);
        }
    }

private:
    bool isGone(std::uint32_t corner) const { return next[corner] == corner; }

    bool isConvex(std::uint32_t corner) const { return turnAt(corner) > 0; }

    double turnAt(std::uint32_t corner) const {
        return orientation(points[previous[corner]], points[corner], points[next[corner]]);
    }

    // Whether the outline turns back on itself or repeats a point.
    bool isSpike(std::uint32_t corner) const {
        const Point2 &p = points[previous[corner]], &x = points[corner], &n = points[next[corner]];
        return (p.x - x.x) * (n.x - x.x) + (p.y - x.y) * (n.y - x.y) >= 0 && turnAt(corner) == 0;
    }

    bool isEar(std::uint32_t corner) {
        if (!isConvex(corner)) return false;
        const Point2 t[3] = {points[next[corner]], points[previous[corner]], points[corner]};
        const auto [low, high] = std::minmax({t[0], t[1], t[2]});
        const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
        const auto isBefore = [this](std::uint32_t i, const Point2& p) { return points[i] < p; };
        auto i = std::lower_bound(blockers.begin(), blockers.end(), low, isBefore);
        for (; i != blockers.end() && !(high < points[*i]); ++i) {
            ++out.steps;
            const Point2& x = points[*i];
            if (bottom <= x.y && x.y <= top && *i != previous[corner] && *i != next[corner] &&
                blocks(t, x, points[previous[*i]], points[next[*i]]))
                return false;
        }
        return true;
    }

    // Continues if a polygon that crosses itself has no ears left.
    void forceCut() {
        out.simple = false;
        std::uint32_t corner = last;
        for (std::size_t i = 0; i < left && !isConvex(corner); ++i) corner = next[corner];
        cut(corner);
    }

    void cut(std::uint32_t corner) {
        out.triangles.push_back({previous[corner], corner, next[corner]});
        drop(corner);
    }

    void drop(std::uint32_t corner) {
        const std::uint32_t p = previous[corner], n = next[corner];
        setBlocker(corner, false);
        next[p] = n;
        previous[n] = p;
        next[corner] = corner;
        last = p;
        --left;
        review(p);
        review(n);
    }

    // Call this for a corner with new neighbours. Spikes are dropped before any ear is cut.
    void review(std::uint32_t corner) {
        setBlocker(corner, !isConvex(corner));
        if (isSpike(corner)) candidates.push_front(corner);
        candidates.push_back(corner);
    }

    void setBlocker(std::uint32_t corner, bool on) {
        if (isBlocker[corner] == on) return;
        isBlocker[corner] = on;
        const auto isLeft = [this](std::uint32_t a, std::uint32_t b) {
            return points[a] == points[b] ? a < b : points[a] < points[b];
        };
        const auto place = std::lower_bound(blockers.begin(), blockers.end(), corner, isLeft);
        if (on)
            blockers.insert(place, corner);
        else
            blockers.erase(place);
    }

    const std::vector<Point2>& points;
    Triangulation& out;
    std::vector<std::uint32_t> previous, next;  // the ring of remaining corners
    std::vector<std::uint32_t> blockers;        // non-convex corners, from left to right
    std::vector<bool> isBlocker;                // whether a corner is one of them
    std::deque<std::uint32_t> candidates;       // for ears and spikes
    std::size_t left;                           // number of remaining corners
    std::uint32_t last = 0;                     // one of them
};

}  // namespace

void cutEars(const std::vector<Point2>& points, Triangulation& result) {
    EarCutter(points, result).cutAll();
}

}  // namespace sw
