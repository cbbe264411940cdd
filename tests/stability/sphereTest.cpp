// How the bound for a sphere is derived. A kernel that rounds is right if its answer is that of a
// sphere moved by delta = exact::shift * D, D = |o - c| + r, with hitT rounded to float. The move
// changes two lengths by delta at most: p, the distance from the centre to the line, and s, where
// on the ray the centre's foot lies. From
//     entry = s - sqrt(r^2 - p^2),  exit = s + sqrt(r^2 - p^2)
// follow the intervals below. Within delta of p = r, hit and miss are both right.

#include "stability/exact.h"
#include "stability/sphereCases.h"

using namespace sw;
using namespace test;
using exact::Interval;
using exact::Real;
using exact::Real3;

namespace {

class Oracle {
public:
    explicit Oracle(const SphereCase& c) : ray(c.ray), r(c.sphere.radius), center(c.sphere.center) {
        const Real3 d(ray.dir), f = Real3(ray.orig) - center;
        const Real size = exact::length(d);
        const Real delta = exact::shift * (exact::length(f) + r);
        const Real s = -dot(f, d) / size, p = exact::length(cross(f, d)) / size;
        const Real longest = halfChord(exact::max(0, p - delta)), shortest = halfChord(p + delta);
        mayMiss = p + delta > r;
        mayHit = p - delta <= r;
        entry = exact::rayParameters(s - delta - longest, s + delta - shortest, size);
        exit = exact::rayParameters(s - delta + shortest, s + delta + longest, size);
        slack = 2 * delta + longest - shortest;
    }

    std::string judgeMiss() const {
        if (mayMiss || !(entry.within(ray) || exit.within(ray))) return "";
        return describe("a miss, but it enters at", static_cast<double>(entry.low), "and leaves at",
                        static_cast<double>(exit.low));
    }

    std::string judgeHit(const Intersection& hit) const {
        const double t = hit.hitT;
        if (!mayHit) return describe("a hit at", t, "of a sphere that the line passes by");
        if (!(ray.minT < hit.hitT && hit.hitT < ray.maxT)) return describe("t", t, "out of limits");
        if (hit.frontFacing && !entry.holds(t)) return describe("entry", t, at(entry).c_str());
        if (!hit.frontFacing && !exit.holds(t)) return describe("exit", t, at(exit).c_str());
        if (!hit.frontFacing && entry.within(ray)) return describe("exit", t, "before entry");
        return judgePoint(hit);
    }

private:
    Real halfChord(Real p) const { return exact::root(r * r - p * p); }

    static std::string at(const Interval& i) {
        return describe("not in", static_cast<double>(i.low), static_cast<double>(i.high));
    }

    std::string judgePoint(const Intersection& hit) const {
        const Real3 fromCenter = Real3(hit.position) - center, normal(hit.normal);
        const Real rounding = 4 * u * (exact::length(center) + r);
        if (exact::abs(exact::length(fromCenter) - r) > rounding) return "position off the sphere";
        if (exact::distanceFromLine(hit.position, ray) > rounding + slack)
            return "position off the ray";
        if (exact::abs(exact::length(normal) - 1) > 4 * u) return "normal not of unit length";
        const Real3 outward = (hit.frontFacing ? r : -r) * normal;
        if (exact::length(fromCenter - outward) > rounding + 4 * u * r) return "wrong normal";
        const Real3 d(ray.dir);
        if (dot(normal, d) > (4 * u + slack / r) * exact::length(d)) return "normal along the ray";
        return "";
    }

    Ray ray;
    Real r;
    Real3 center;
    bool mayMiss, mayHit;
    Interval entry, exit;
    Real slack;  // how far apart two right answers may lie
};

}  // namespace

TEST_CASE("a sphere is hit where exact arithmetic says") {
    int hits = 0;
    checkRandomCases(4 * familySize, [&](Random& random) {
        const SphereCase c = randomSphereCase(random);
        Intersection hit;
        const bool found = c.sphere.intersect(c.ray, hit);
        hits += found;
        const Oracle oracle(c);
        const std::string problem = found ? oracle.judgeHit(hit) : oracle.judgeMiss();
        return problem.empty() ? problem : problem + " " + describe(c.ray, c.sphere);
    });
    CHECK(hits > 2 * familySize);
}

TEST_CASE("a hit on a sphere counts up to one ulp from the limits") {
    int hits = 0;
    checkRandomCases(2 * familySize, [&](Random& random) {
        const SphereCase c = randomSphereCase(random);
        Intersection hit, again;
        if (!c.sphere.intersect(c.ray, hit)) return std::string();
        ++hits;
        const float t = hit.hitT;
        const float before = std::nextafter(t, 0.0f), after = std::nextafter(t, HUGE_VALF);
        const auto hitsAt = [&](float minT, float maxT) {
            const Ray ray(c.ray.orig, c.ray.dir, minT, maxT);
            return c.sphere.intersect(ray, again) && again.hitT == t;
        };
        const bool right = hitsAt(before, after) && !hitsAt(t, after) && !hitsAt(before, t) &&
                           !hitsAt(after, HUGE_VALF) && !hitsAt(0, before);
        return right ? "" : describe("at t =", t, c.ray, c.sphere);
    });
    CHECK(hits > familySize);
}
