#include "nff/polygon/crossings.h"

#include <algorithm>

namespace sw {
namespace {

struct Side {
    Side(const Point2& a, const Point2& b)
        : left(std::min(a, b)),
          right(std::max(a, b)),
          bottom(std::min(a.y, b.y)),
          top(std::max(a.y, b.y)) {}

    Point2 left, right;
    double bottom, top;
};

// Whether the ends of t lie strictly on different sides of the line through s.
bool separates(const Side& s, const Side& t) {
    const double side = orientation(s.left, s.right, t.left);
    return side != 0 && side * orientation(s.left, s.right, t.right) < 0;
}

bool cross(const Side& s, const Side& t) {
    if (!(s.bottom < t.top && t.bottom < s.top)) return false;
    if (s.left == t.left || s.right == t.right) return false;  // decided without exact sums
    return separates(s, t) && separates(t, s);
}

}  // namespace

bool hasCrossings(const std::vector<Point2>& polygon) {
    std::vector<Side> sides;
    sides.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sides.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    const auto startsBefore = [](const Side& s, const Side& t) { return s.left.x < t.left.x; };
    std::sort(sides.begin(), sides.end(), startsBefore);
    for (auto s = sides.begin(); s != sides.end(); ++s)
        for (auto t = s + 1; t != sides.end() && t->left.x < s->right.x; ++t)
            if (cross(*s, *t)) return true;
    return false;
}

}  // namespace sw
