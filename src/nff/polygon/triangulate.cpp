#include "nff/polygon/triangulate.h"

#include <algorithm>

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

// How far the corners are from the first one.
double extentOf(Corners corners) {
    double squared = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const dvec3 v = fromFirst(corners, i);
        squared = std::max(squared, dot(v, v));
    }
    return std::sqrt(squared);
}

// Newell's normal, twice as long as the enclosed area: on the side where the corners are
// counter-clockwise.
dvec3 newellNormal(Corners corners) {
    dvec3 sum(0, 0, 0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += cross(fromFirst(corners, i - 1), fromFirst(corners, i));
    return sum;
}

// The normal of a large triangle between corners.
dvec3 largeTriangle(Corners corners) {
    dvec3 farthest(0, 0, 0), largest(0, 0, 0);
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const dvec3 v = fromFirst(corners, i);
        if (dot(v, v) > dot(farthest, farthest)) farthest = v;
    }
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const dvec3 n = cross(farthest, fromFirst(corners, i));
        if (dot(n, n) > dot(largest, largest)) largest = n;
    }
    return largest;
}

// Of unit length; NaN for corners on a line. Newell's normal of a thin winding polygon or a figure
// of eight is a small difference of large areas, and points somewhere.
dvec3 normalOf(Corners corners, double extent) {
    const dvec3 n = newellNormal(corners);
    if (!(glm::length(n) < 0x1p-7 * extent * extent)) return glm::normalize(n);
    const dvec3 large = largeTriangle(corners);
    return glm::normalize(dot(large, n) < 0 ? -large : large);
}

// Drops the coordinate along which the normal is longest. What is counter-clockwise stays so, and
// the coordinates stay floats.
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

bool isPlanar(Corners corners, const dvec3& normal, double extent) {
    double lowest = 0, highest = 0;
    float largest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double height = dot(fromFirst(corners, i), normal);
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
        largest = std::max(largest, num::maxAbs(corners[i]));
    }
    const double rounding = 4.0 * num::unitRoundoff * largest;
    return highest - lowest <= 1e-3 * extent + rounding;
}

// Whether all triangles between the first corner and a side are counter-clockwise and span less
// than half a turn together: those of every convex polygon, and they do not overlap.
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

void cutFan(Triangulation& result, std::size_t count) {
    for (std::uint32_t i = 2; i < count; ++i) result.triangles.push_back({0, i - 1, i});
}

void cutEars(Triangulation& result, Corners corners, const Projection& project) {
    std::vector<Point2> points;
    points.reserve(corners.size());
    for (const Vec3& corner : corners) points.push_back(project(corner));
    result.simple = !hasCrossings(points);
    EarCutter(points, result).cutAll();
}

}  // namespace

Triangulation triangulate(Corners corners) {
    Triangulation result;
    if (corners.size() < 3) return result;
    const double extent = extentOf(corners);
    const dvec3 normal = normalOf(corners, extent);
    if (!(dot(normal, normal) > 0)) return result;  // a line, or not finite
    result.planar = isPlanar(corners, normal, extent);
    result.triangles.reserve(corners.size() - 2);
    const Projection project(normal);
    if (isFan(corners, project))
        cutFan(result, corners.size());
    else
        cutEars(result, corners, project);
    return result;
}

}  // namespace sw
