#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

#include "nff/polygon/orientation.h"

namespace sw {

/// Finds out whether a triangle holds any of many points, each of which can be switched on and off.
/// A binary tree of boxes in an array: node i has the children 2i and 2i + 1, and a box around
/// those of its points that are on.
class PointTree {
public:
    /// All points are off.
    explicit PointTree(const std::vector<Point2>& allPoints)
        : points(allPoints),
          leaves(std::bit_ceil(allPoints.size())),
          boxes(2 * leaves),
          inLeaf(allPoints.size()),
          leafOf(allPoints.size()) {
        std::iota(inLeaf.begin(), inLeaf.end(), 0u);
        arrange(0, leaves);
        for (std::uint32_t i = 0; i < inLeaf.size(); ++i) leafOf[inLeaf[i]] = i;
    }

    bool isOn(std::uint32_t point) const { return !boxes[leaves + leafOf[point]].isEmpty(); }

    void set(std::uint32_t point, bool on) {
        std::size_t node = leaves + leafOf[point];
        boxes[node] = on ? Box{points[point], points[point]} : Box();
        while ((node /= 2) > 0) boxes[node] = around(boxes[2 * node], boxes[2 * node + 1]);
    }

    /// @param triangle  three points, counter-clockwise
    /// @param accept    called with each point inside or on the edge, until it returns true
    /// @param steps     is increased by the number of boxes that were looked at
    /// @param most      gives up when steps reaches it
    /// @return          whether accept() returned true, or the search was given up
    template <typename Accept>
    bool any(const Point2 (&triangle)[3], const Accept& accept, std::size_t& steps,
             std::size_t most) const {
        const Query<Accept> query{triangle, around(triangle), accept, steps, most};
        return anyBelow(1, query);
    }

private:
    struct Box {
        Point2 low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};

        bool isEmpty() const { return low.x > high.x; }
    };

    template <typename Accept>
    struct Query {
        const Point2 (&triangle)[3];
        Box box;
        const Accept& accept;
        std::size_t& steps;
        std::size_t most;
    };

    static Box around(const Point2 (&triangle)[3]) {
        Box box;
        for (const Point2& p : triangle) box = around(box, {p, p});
        return box;
    }

    // An empty box overlaps none.
    static bool overlap(const Box& a, const Box& b) {
        return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
               b.low.y <= a.high.y;
    }

    static Box around(const Box& a, const Box& b) {
        return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
                {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
    }

    // Whether all of the box lies to the right of a side; its corner farthest to the left decides.
    static bool isBeyond(const Box& box, const Point2& from, const Point2& to) {
        const Point2 farthest{to.y > from.y ? box.low.x : box.high.x,
                              to.x > from.x ? box.high.y : box.low.y};
        return orientation(from, to, farthest) < 0;
    }

    template <typename Accept>
    bool anyBelow(std::size_t node, const Query<Accept>& query) const {
        const Box& box = boxes[node];
        if (++query.steps >= query.most) return true;
        if (!overlap(box, query.box)) return false;
        for (int i = 0; i < 3; ++i)
            if (isBeyond(box, query.triangle[i], query.triangle[(i + 1) % 3])) return false;
        if (node >= leaves) return query.accept(inLeaf[node - leaves]);
        return anyBelow(2 * node, query) || anyBelow(2 * node + 1, query);
    }

    // Sorts the points of the leaves from first to last, so that neighbours share small boxes.
    void arrange(std::size_t first, std::size_t last) {
        const std::size_t middle = (first + last) / 2, end = std::min(last, points.size());
        if (end < first + 2) return;
        const auto begin = inLeaf.begin();
        const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
        if (middle < end) {
            const bool byX = isWide(first, end);
            std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
                return byX ? points[a].x < points[b].x : points[a].y < points[b].y;
            });
        }
        arrange(first, middle);
        arrange(middle, last);
    }

    bool isWide(std::size_t first, std::size_t end) const {
        Box box;
        for (std::size_t i = first; i < end; ++i)
            box = around(box, {points[inLeaf[i]], points[inLeaf[i]]});
        return box.high.x - box.low.x > box.high.y - box.low.y;
    }

    const std::vector<Point2>& points;
    std::size_t leaves;  // a power of two; as many nodes stand above them
    std::vector<Box> boxes;
    std::vector<std::uint32_t> inLeaf, leafOf;
};

}  // namespace sw
