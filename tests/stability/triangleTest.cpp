// How the bound for a triangle is derived. A kernel that rounds is right if its answer is that of a
// triangle whose vertices are moved by delta = exact::shift * D, D = max |v_i - o|, each in its own
// direction, with hitT rounded to float. Seen along the ray this moves every edge by delta at most:
// where the ray passes within delta of one, hit and miss are both right. At the hit, the move is a
// mean of the corners' moves; a part along the ray changes the distance by delta, and a part across
// it by delta tan(theta), as much as the plane rises. Together these are at most
// delta sqrt(2) / cos(theta), taken as 2 delta / cos(theta). The weights of this mean come from
// edge functions p x q, each rounded relative to |p| |q|; so for hitT delta grows with (longest
// edge)^2 / area as the ray sees them, up to the 8u D that the issue grants. A triangle that looks
// narrower than 64 delta may be tilted as well: its hit lies between its corners' distances.

#include "stability/exact.h"
#include "stability/triangleCases.h"

using namespace sw;
using namespace test;
using exact::Interval;
using exact::Real;
using exact::Real3;

namespace {

class Oracle {
public:
    explicit Oracle(const TriangleCase& c) : ray(c.ray), d(c.ray.dir), size(exact::length(d)) {
        for (int i = 0; i < 3; ++i) v[i] = Real3(c.triangle.vertices[i]) - Real3(ray.orig);
        n = cross(v[1] - v[0], v[2] - v[0]);
        const Real3 longest(exact::length(v[0]), exact::length(v[1]), exact::length(v[2]));
        delta = exact::shift * exact::max(longest.x, exact::max(longest.y, longest.z));
        lookAlongRay();
        findHit();
    }

    std::string judgeMiss() const {
        if (!inside || margin <= delta || !hasArea() || !interval.within(ray)) return "";
        return describe("a miss, but it passes inside by", static_cast<double>(margin), "at",
                        static_cast<double>(interval.low));
    }

    std::string judgeHit(const Triangle& triangle, const Intersection& hit) const {
        const double t = hit.hitT;
        if (!hasArea()) return "a hit on a triangle without area";
        if (!inside && margin > delta)
            return describe("a hit, but it passes outside by", static_cast<double>(margin));
        if (!(ray.minT < hit.hitT && hit.hitT < ray.maxT)) return describe("t", t, "out of limits");
        if (!interval.holds(t))
            return describe("t", t, "not in", static_cast<double>(interval.low),
                            static_cast<double>(interval.high));
        return judgePoint(triangle, hit);
    }

private:
    bool hasArea() const { return dot(n, n) > 0; }

    // Whether the ray passes inside, and how far from the nearest edge.
    void lookAlongRay() {
        bool left = false, right = false;
        Real area = 0, longestEdge = 0;
        for (int i = 0; i < 3; ++i) {
            const Real3 p = acrossRay(v[i]), q = acrossRay(v[(i + 1) % 3]), e = q - p;
            const Real twiceArea = dot(d, cross(p, q)) / size;
            left |= twiceArea > 0;
            right |= twiceArea < 0;
            area += twiceArea;
            const Real edge = dot(e, e);
            longestEdge = exact::max(longestEdge, edge);
            const Real foot = edge > 0 ? exact::min(1, exact::max(0, -dot(p, e) / edge)) : Real(0);
            const Real distance = exact::length(p + foot * e);
            margin = i == 0 ? distance : exact::min(margin, distance);
        }
        inside = !(left && right) && (left || right);
        narrow = exact::abs(area) < 64 * delta * exact::root(longestEdge);
        if (!narrow) stretch = exact::max(1, longestEdge / exact::abs(area));
    }

    void findHit() {
        Real low = along(v[0]), high = low;
        for (const Real3& p : v) {
            low = exact::min(low, along(p));
            high = exact::max(high, along(p));
        }
        slack = 2 * delta + high - low;
        if (!narrow) {
            const Real slope = dot(n, d);
            const Real move = delta * exact::min(stretch, exact::roundings / exact::shift);
            low = high = dot(n, v[0]) / slope * size;
            slack = 2 * move * exact::length(n) * size / exact::abs(slope);
        }
        interval = exact::rayParameters(low - slack, high + slack, size);
    }

    std::string judgePoint(const Triangle& triangle, const Intersection& hit) const {
        const Real3 normal = exact::unit(n), shown(hit.normal);
        Real largest = 0;
        for (const Vec3& vertex : triangle.vertices)
            largest = exact::max(largest, exact::length(Real3(vertex)));
        const Real3 fromCorner = Real3(hit.position) - Real3(triangle.vertices[0]);
        if (exact::abs(dot(normal, fromCorner)) > 8 * u * largest) return "position off the plane";
        if (exact::distanceFromLine(hit.position, ray) > 8 * u * largest + slack)
            return "position off the ray";
        if (exact::abs(exact::length(shown) - 1) > 4 * u) return "normal not of unit length";
        const Real3 outward = (hit.frontFacing ? 1 : -1) * shown;
        if (exact::length(outward - normal) > 4 * u) return "wrong normal";
        if (dot(d, shown) > 4 * u * size) return "normal along the ray";
        return "";
    }

    Real along(const Real3& p) const { return dot(p, d) / size; }
    Real3 acrossRay(const Real3& p) const { return p - (dot(p, d) / (size * size)) * d; }

    Ray ray;
    Real3 d;
    Real size;
    Real3 v[3];  // from the ray's origin
    Real3 n;
    Real delta;
    bool inside, narrow;
    Real stretch = 1;
    Real margin;
    Real slack;
    Interval interval;
};

}  // namespace

TEST_CASE("a triangle is hit where exact arithmetic says") {
    int hits = 0;
    checkRandomCases(5 * familySize, [&](Random& random) {
        const TriangleCase c = randomTriangleCase(random);
        Intersection hit;
        const bool found = c.triangle.intersect(c.ray, hit);
        hits += found;
        const Oracle oracle(c);
        const std::string problem = found ? oracle.judgeHit(c.triangle, hit) : oracle.judgeMiss();
        return problem.empty() ? problem : problem + " " + describe(c.ray, c.triangle);
    });
    CHECK(hits > familySize);
}

TEST_CASE("a hit on a triangle counts up to one ulp from the limits") {
    int hits = 0;
    checkRandomCases(5 * familySize, [&](Random& random) {
        const TriangleCase c = randomTriangleCase(random);
        Intersection hit, again;
        if (!c.triangle.intersect(c.ray, hit)) return std::string();
        ++hits;
        const float t = hit.hitT;
        const float before = std::nextafter(t, 0.0f), after = std::nextafter(t, HUGE_VALF);
        const auto hitsAt = [&](float minT, float maxT) {
            const Ray ray(c.ray.orig, c.ray.dir, minT, maxT);
            return c.triangle.intersect(ray, again) && again.hitT == t;
        };
        const bool right = hitsAt(before, after) && !hitsAt(t, after) && !hitsAt(before, t);
        return right ? "" : describe("at t =", t, c.ray, c.triangle);
    });
    CHECK(hits > familySize);
}

TEST_CASE("a triangle without area is never hit") {
    checkRandomCases(familySize, [](Random& random) {
        // On a grid that floats hold exactly, so that the corners are collinear in exact
        // arithmetic, but too fine for double's products: the edge functions alone do not tell.
        constexpr double grid = 0x1p-20;
        const auto onGrid = [&](double side) {
            const dvec3 p = toDouble(random.point(side));
            return num::toFloat(grid * round(p / grid));
        };
        const Vec3 from = onGrid(8), step = onGrid(1);
        const Vec3 corners[] = {from, from + step * random.whole(-3, 3),
                                from + step * random.whole(-3, 3)};
        const Triangle flat(corners, Material());
        const Vec3 origin = onGrid(15);
        Intersection hit;
        const Ray ray(origin, from + step * random.whole(-2, 2) - origin);
        return flat.intersect(ray, hit) ? describe(ray, flat) : "";
    });
}
