#include "nff/polygon/triangulate.h"

#include <algorithm>
#include <iterator>

#include "nff/polygon/crossings.h"
#include "nff/polygon/earCutter.h"
#include "swNumerics.h"

namespace sw {
namespace {

using glm::dvec3;
using Corners = std::span<const Vec3>;

dvec3 fromFirst(Corners corners, std::size_t i) {
    return num::toDouble(corners[i]) - num::toDouble(corners[0]);
}

struct Plane {
    explicit Plane(Corners corners);

    dvec3 normal;   // the corners are counter-clockwise around it; NaN for a line
    double extent;  // distance of the farthest corner from the first one
};

Plane::Plane(Corners corners) {
    dvec3 newell(0, 0, 0), farthest(0, 0, 0), largest(0, 0, 0);
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const dvec3 v = fromFirst(corners, i);
        newell += cross(fromFirst(corners, i - 1), v);
        if (dot(v, v) > dot(farthest, farthest)) farthest = v;
    }
    extent = glm::length(farthest);
    normal = glm::normalize(newell);
    if (!(glm::length(newell) < 0x1p-7 * extent * extent)) return;
    // For a thin winding polygon or a figure of eight, Newell's normal is a small difference of
    // large areas and thus unreliable. The normal of a large triangle between corners replaces it.
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const dvec3 n = cross(farthest, fromFirst(corners, i));
        if (dot(n, n) > dot(largest, largest)) largest = n;
    }
    normal = glm::normalize(dot(largest, newell) < 0 ? -largest : largest);
}

// Drops the coordinate along which the normal is longest. The orientation is kept, and the
// coordinates stay floats.
class Projection {
public:
    explicit Projection(const dvec3& normal) {
        const dvec3 n = abs(normal);
        const int dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
        x = (dropped + 1) % 3;
        y = (dropped + 2) % 3;
        if (normal[dropped] < 0) std::swap(x, y);
    }

    Point2 operator()(const Vec3& v) const { return {v[x], v[y]}; }

private:
    int x, y;
};

bool isPlanar(Corners corners, const Plane& plane) {
    double height = 0;
    float largest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        height = std::max(height, std::fabs(dot(fromFirst(corners, i), plane.normal)));
        largest = std::max(largest, num::maxAbs(corners[i]));
    }
    const double rounding = 4.0 * num::unitRoundoff * largest;
    return height <= 1e-3 * plane.extent + rounding;
}

// Whether all triangles between the first corner and a side are counter-clockwise and together span
// less than half a turn. Then they do not overlap. This holds for every convex polygon.
bool isFan(Corners corners, const Projection& project) {
    const Point2 hub = project(corners[0]), first = project(corners[1]);
    Point2 last = first;
    for (const Vec3& corner : corners.subspan(2)) {
        const Point2 point = project(corner);
        if (!(orientation(hub, last, point) > 0 && orientation(hub, first, point) > 0))
            return false;
        last = point;
    }
    return true;
}

}  // namespace

Triangulation triangulate(Corners corners) {
    Triangulation result;
    if (corners.size() < 3) return result;
    const Plane plane(corners);
    if (!(dot(plane.normal, plane.normal) > 0)) return result;  // a line, or not finite
    result.planar = isPlanar(corners, plane);
    result.triangles.reserve(corners.size() - 2);
    const Projection project(plane.normal);
    if (isFan(corners, project)) {
        for (std::uint32_t i = 2; i < corners.size(); ++i)
            result.triangles.push_back({0, i - 1, i});
        return result;
    }
    std::vector<Point2> points;
    std::transform(corners.begin(), corners.end(), std::back_inserter(points), project);
    result.simple = !hasCrossings(points);
    cutEars(points, result);
    return result;
}

}  // namespace sw
