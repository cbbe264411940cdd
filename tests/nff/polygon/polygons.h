#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "nff/polygon/triangulate.h"
#include "support.h"

/// Polygons in the plane z = 0, counter-clockwise.
namespace test {

using Polygon = std::vector<Vec3>;

/// How many corners belong to triangles.
inline std::size_t usedCorners(const Polygon& polygon, const sw::Triangulation& cut) {
    std::vector<bool> used(polygon.size());
    for (const auto& triangle : cut.triangles)
        for (const std::uint32_t i : triangle) used.at(i) = true;
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

constexpr double fullTurn = 6.283185307179586;

inline Vec3 polar(double radius, double angle) {
    return {static_cast<float>(radius * std::cos(angle)),
            static_cast<float>(radius * std::sin(angle)), 0};
}

/// Around the origin, `turns` times.
inline Polygon star(int count, const std::function<double(int)>& radius, int turns = 1) {
    Polygon polygon;
    for (int i = 0; i < count; ++i)
        polygon.push_back(polar(radius(i), fullTurn * turns * i / count));
    return polygon;
}

/// Two lines from left to right, with heights above and below of 0.
inline Polygon band(int half, const std::function<double(int)>& lower,
                    const std::function<double(int)>& upper) {
    Polygon polygon;
    const auto push = [&](int i, double y) {
        polygon.push_back({static_cast<float>(i), static_cast<float>(y), 0});
    };
    for (int i = 0; i < half; ++i) push(i, lower(i));
    for (int i = half; i-- > 0;) push(i, upper(i));
    return polygon;
}

inline Polygon comb(int half, double tooth) {
    return band(
        half, [](int) { return -1.0; }, [&](int i) { return i % 2 == 0 ? 0.0 : tooth; });
}

inline Polygon zigzag(int half, double height) {
    const auto lower = [=](int i) { return i % 2 == 0 ? 0.0 : height; };
    return band(half, lower, [=](int i) { return lower(i) + 1; });
}

inline Polygon spiral(int half, double turns) {
    Polygon polygon;
    const auto push = [&](int i, double more) {
        const double way = turns * i / half;
        polygon.push_back(polar(way + more, fullTurn * way));
    };
    for (int i = half; i-- > 0;) push(i, 1);
    for (int i = 0; i < half; ++i) push(i, 1.5);
    return polygon;
}

/// A room with triangular holes, each on a bridge of two coinciding edges. Whole coordinates.
inline Polygon keyholes(Random& random, int holes) {
    const auto at = [](int x, int y) {
        return Vec3(static_cast<float>(x), static_cast<float>(y), 0);
    };
    Polygon polygon = {at(8 * holes, 0), at(8 * holes, 40), at(-1, 40), at(-1, 0)};
    for (int i = 0; i < holes; ++i) {
        const int x = 8 * i, y = random.whole(1, 20);
        for (const Vec3& p : {at(x, 0), at(x, y), at(x + 1, y + random.whole(5, 15)),
                              at(x + 5, y + random.whole(0, 4)), at(x, y), at(x, 0)})
            polygon.push_back(p);
    }
    return polygon;
}

/// Cuts each side into up to five equal parts, which may move corners by a rounding error.
inline Polygon subdivided(Random& random, const Polygon& coarse) {
    Polygon polygon;
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        const Vec3 side = coarse[(i + 1) % coarse.size()] - coarse[i];
        const int parts[] = {1, 2, 3, 5}, count = parts[random.whole(0, 3)];
        for (int k = 0; k < count; ++k)
            polygon.push_back(coarse[i] +
                              side * (static_cast<float>(k) / static_cast<float>(count)));
    }
    return polygon;
}

inline Polygon randomSimple(Random& random, int count) {
    const auto any = [&random](double low, double high) {
        return [&random, low, high](int) { return random.uniform(low, high); };
    };
    const int half = count / 2, kind = random.whole(0, 5);
    if (kind == 0) return star(count, any(1, 2));
    if (kind == 1) return star(count, any(0.05, 2));
    if (kind == 2) return band(half, any(-20, -0.1), any(0.1, 20));
    if (kind == 3) return comb(half, random.uniform(0.1, 50));
    if (kind == 4) return zigzag(half, random.uniform(0.1, 50));
    return spiral(half + 20, random.uniform(0.1, half / 10.0 + 1));
}

/// Somewhere in space, in any plane and at any scale.
struct Placement {
    explicit Placement(Random& random)
        : scale(random.magnitude(1e-8, 1e8)),
          normal(toDouble(random.direction())),
          offset(toDouble(random.point(100))) {
        const dvec3 other = std::fabs(normal.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
        x = glm::normalize(cross(other, normal));
    }

    Polygon operator()(const Polygon& flat) const {
        const dvec3 y = cross(normal, x);
        Polygon polygon;
        for (const Vec3& p : flat)
            polygon.push_back(sw::num::toFloat(
                static_cast<double>(scale) *
                (offset + static_cast<double>(p[0]) * x + static_cast<double>(p[1]) * y)));
        return polygon;
    }

    /// In the plane y = 0.
    static Polygon upright(Polygon polygon) {
        for (Vec3& p : polygon) p = Vec3(p[1], 0, p[0]);
        return polygon;
    }

    float scale;
    dvec3 normal, offset, x;
};

inline Polygon turned(Polygon polygon, double angle) {
    for (Vec3& p : polygon) {
        const double x = p[0], y = p[1];
        p = {static_cast<float>(x * std::cos(angle) - y * std::sin(angle)),
             static_cast<float>(x * std::sin(angle) + y * std::cos(angle)), 0};
    }
    return polygon;
}

/// Simple polygons of any number of corners that take long to cut: most of them stand in the way of
/// many ears.
inline std::vector<std::pair<std::string, std::function<Polygon(int)>>> largePolygons() {
    const auto room = [](int n) {
        Random random(1);
        return keyholes(random, n / 6);
    };
    return {
        {"comb", [](int n) { return comb(n / 2, 5); }},
        {"turned comb", [](int n) { return turned(comb(n / 2, 5), 0.7); }},
        {"long teeth", [](int n) { return comb(n / 2, n); }},
        {"zigzag", [](int n) { return zigzag(n / 2, 1); }},
        {"turned zigzag", [](int n) { return turned(zigzag(n / 2, 1), 0.4); }},
        {"spiral", [](int n) { return spiral(n / 2, 10); }},
        {"tight spiral", [](int n) { return spiral(n / 2, n / 100.0); }},
        {"spikes", [](int n) { return star(n, [](int i) { return i % 2 == 0 ? 0.01 : 1.0; }); }},
        {"keyholes", room},
        {"turned keyholes", [room](int n) { return turned(room(n), 0.3); }}};
}

}  // namespace test
