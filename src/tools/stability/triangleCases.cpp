#include <algorithm>

#include "tools/common/random.h"
#include "tools/stability/cases.h"

namespace report {
namespace {

using sw::num::toDouble;
using sw::num::toFloat;

using Corners = std::array<dvec3, 3>;

sw::Triangle toTriangle(const dvec3& a, const dvec3& b, const dvec3& c) {
    const sw::Vec3 v[] = {toFloat(a), toFloat(b), toFloat(c)};
    return {v, sw::Material()};
}

Corners ordinary() {
    return {inCube(1), inCube(1), inCube(1)};  // braces fix the order: left to right
}

// 1 .. 3 long, and up to 1e7 times narrower.
Corners sliver() {
    const dvec3 a = inCube(1);
    const dvec3 along = direction();
    const dvec3 edge = between(1, 3) * along;
    const dvec3 aside = perpendicular(along);
    const dvec3 width = magnitude(1e-7, 1e-2) * aside;
    return {a, a + edge, a + between(0, 1) * edge + width};
}

Corners distant() {
    const dvec3 offset = 1e6 * direction();
    Corners corners = ordinary();
    for (dvec3& corner : corners) corner += offset;
    return corners;
}

// Starts somewhere on the way to the target.
sw::Ray rayTo(const dvec3& target, const dvec3& towards) {
    const sw::Vec3 origin = toFloat(target - between(1, 10) * towards);
    return {origin, toFloat(normalize(target - toDouble(origin)))};
}

// A random point of the triangle's plane; about half of them lie in the triangle.
dvec3 near(const Corners& corners) {
    const double v = between(-0.1, 0.9), w = between(-0.1, 0.9);
    return corners[0] + v * (corners[1] - corners[0]) + w * (corners[2] - corners[0]);
}

Family<sw::Triangle> family(const std::string& name, Corners (*recipe)(), int size) {
    Family<sw::Triangle> result{name, {}};
    sw::seedPixel(1, 0, 0);
    while (result.cases.size() < static_cast<std::size_t>(size)) {
        const Corners corners = recipe();
        const sw::Triangle triangle = toTriangle(corners[0], corners[1], corners[2]);
        const dvec3 target = near(corners);
        const sw::Ray ray = rayTo(target, direction());
        const Truth truth = exactHit(triangle, ray);
        if (truth.certain) result.cases.push_back({triangle, ray, truth});
    }
    return result;
}

}  // namespace

std::vector<Family<sw::Triangle>> triangleFamilies(int size) {
    Family<sw::Triangle> edges{"shared edges", {}};
    for (int i = 0; edges.cases.size() < static_cast<std::size_t>(size); ++i) {
        const EdgeCase edge = edgeCase(i);
        const sw::Triangle& triangle = edge.triangles[static_cast<std::size_t>(i % 2)];
        const Truth truth = exactHit(triangle, edge.ray);
        if (truth.certain) edges.cases.push_back({triangle, edge.ray, truth});
    }
    return {family("ordinary", ordinary, size), family("slivers", sliver, size),
            family("offset 1e6", distant, size), std::move(edges)};
}

EdgeCase edgeCase(int index) {
    sw::seedPixel(2, index, 0);
    // Seen along the ray the edge is long and the other two vertices lie well to its sides, so
    // that rounding cannot carry the ray past them.
    const dvec3 towards = direction();
    const dvec3 along = perpendicular(towards);
    const dvec3 a = inCube(1);
    const double length = between(0.5, 2);
    const dvec3 edge = length * along + between(-1, 1) * towards;
    const auto beside = [&](double sign) {
        const dvec3 foot = a + between(0, 1) * edge;
        const dvec3 aside = sign * between(0.5, 2) * cross(towards, along);
        return foot + aside + between(-1, 1) * towards;
    };
    const dvec3 b = a + edge, c = beside(1), d = beside(-1);
    const dvec3 target = a + between(0.1, 0.9) * edge;
    return {{toTriangle(a, b, c), toTriangle(b, a, d)}, rayTo(target, towards)};
}

}  // namespace report
