// How the bound for a cone is derived. A kernel that rounds is right if its answer is that of a
// cone moved by delta = exact::shift * D, D = |o - base| + extent, with hitT rounded to float. The
// move lies between two cones: all points up to delta outside of the mantle, and those delta inside
// of it. The outer one is entered earlier and left later, the inner one the other way round;
// between the two lies every right answer. Where only the outer one is hit, hit and miss are both
// right; so they are within delta of the ends.

#include "stability/coneCases.h"
#include "stability/exact.h"

using namespace sw;
using namespace test;
using exact::Interval;
using exact::Real;
using exact::Real3;

namespace {

// A crossing of the endless cone: whether there is one, where, how far up the slant, and the
// cosine times the radius there.
struct Crossing {
    bool exists = false;
    Real t = 0, up = 0, radius = 0;
};

// The cone in exact arithmetic, and a ray split into parts along and across its axis.
class ExactCone {
public:
    ExactCone(const Cone& cone, const Ray& ray) {
        const Real3 way = Real3(cone.apex) - Real3(cone.base);
        const Real height = exact::length(way);
        axis = exact::unit(way);
        base = Real3(cone.base);
        r = exact::abs(cone.baseRadius);
        const Real end = exact::abs(cone.apexRadius), growth = end - r;
        slant = exact::root(height * height + growth * growth);
        cosine = height / slant;
        sine = growth / slant;
        d = Real3(ray.dir);
        const Real3 f = Real3(ray.orig) - base;
        start = -dot(f, d) / dot(d, d);
        o = f + start * d;
    }

    // Where the mantle moved outwards by `inflation` is entered (side = -1) or left (side = 1).
    Crossing crossing(int side, Real inflation) const {
        const Real3 across = o - dot(o, axis) * axis, speed = d - dot(d, axis) * axis;
        const Real radius = cosine * r + sine * dot(o, axis) + inflation;
        const Real s = sine * dot(d, axis), cc = cosine * cosine;
        const Real a = cc * dot(speed, speed) - s * s;
        const Real b = cc * dot(across, speed) - radius * s;
        const Real c = cc * dot(across, across) - radius * radius;
        Crossing x;
        const Real discriminant = b * b - a * c;
        if (discriminant < 0 && a >= 0) return x;  // a steep ray never misses
        const Real root = side * exact::root(discriminant);
        const bool sameSign = (b > 0) == (root < 0);
        if (sameSign ? a == 0 : root - b == 0 && a == 0) return x;
        x.t = sameSign || b == 0 ? (root - b) / a : c / (-b - root);
        const Real height = dot(o, axis) + x.t * dot(d, axis);
        x.radius = radius + s * x.t;
        x.up = cosine * height + sine * ((x.radius - inflation) / cosine - r);
        x.t = x.t + start;
        x.exists = a < 0 ? (side < 0) == (s > 0) : x.radius >= 0;  // not the mirror image
        return x;
    }

    // How far a point lies outside of the endless mantle, and how far up the slant.
    Real height(const Real3& p) const {
        const Real z = dot(p - base, axis);
        return cosine * exact::length(p - base - z * axis) - (cosine * r + sine * z);
    }
    Real up(const Real3& p) const {
        const Real z = dot(p - base, axis);
        return cosine * z + sine * (exact::length(p - base - z * axis) - r);
    }
    Real3 outwards(const Real3& p) const {
        const Real3 across = p - base - dot(p - base, axis) * axis;
        return cosine * exact::unit(across) - sine * axis;
    }
    Real fromAxis(const Real3& p) const {
        return exact::length(p - base - dot(p - base, axis) * axis);
    }

    Real slant = 0;

private:
    Real3 axis, base, d, o;
    Real r = 0, cosine = 0, sine = 0, start = 0;
};

// Where a side of the surface may be met, and whether it must be.
struct Expected {
    bool may = false, must = false;
    Interval t{0, 0};
    Real width = 0;  // how far apart two right answers may lie, as a length
};

class Oracle {
public:
    explicit Oracle(const ConeCase& c)
        : ray(c.ray), cone(c.cone), exactly(c.cone, c.ray), size(exact::length(Real3(c.ray.dir))) {
        const Real reach = exact::length(Real3(ray.orig) - Real3(cone.base)) + extentOf(cone);
        delta = exact::shift * reach;
        entry = expect(-1);
        exit = expect(1);
        if (cone.baseRadius + cone.apexRadius < 0) entry = Expected();
    }

    std::string judgeMiss() const {
        if (entry.must) return describe("a miss, but it enters at", double(entry.t.low));
        if (exit.must) return describe("a miss, but it leaves at", double(exit.t.low));
        return "";
    }

    std::string judgeHit(const Intersection& hit) const {
        const bool inside = cone.baseRadius + cone.apexRadius < 0;
        if (inside && !hit.frontFacing) return "the back of an inside";
        const Expected& expected = hit.frontFacing && !inside ? entry : exit;
        const Expected& other = hit.frontFacing && !inside ? exit : entry;
        if (!expected.may) return describe("a hit at", hit.hitT, "where there is none");
        if (!expected.t.holds(hit.hitT))
            return describe("t", hit.hitT, "not in", double(expected.t.low),
                            double(expected.t.high));
        if (!(ray.minT < hit.hitT && hit.hitT < ray.maxT)) return "t out of limits";
        if (other.must && other.t.high < expected.t.low) return "not the nearest hit";
        return judgePoint(hit, expected.width);
    }

private:
    Expected expect(int side) const {
        const Crossing outer = exactly.crossing(side, delta),
                       inner = exactly.crossing(side, -delta);
        const Crossing end = inner.exists ? inner : exactly.crossing(-side, delta);
        Expected e;
        if (!outer.exists || (!inner.exists && !end.exists)) return e;
        const Real step = delta / size, low = exact::min(outer.t, end.t),
                   high = exact::max(outer.t, end.t);
        e.t = exact::rayParameters((low - step) * size, (high + step) * size, size);
        e.width = (high - low + 2 * step) * size;
        const Real lowest = exact::min(outer.up, end.up), highest = exact::max(outer.up, end.up);
        const Real room = 2 * delta;
        e.may = lowest <= exactly.slant + room && highest >= -room;
        e.must =
            inner.exists && lowest >= room && highest <= exactly.slant - room && e.t.within(ray);
        return e;
    }

    std::string judgePoint(const Intersection& hit, Real width) const {
        const Real3 p(hit.position), normal(hit.normal), d(ray.dir);
        const Real rounding = 4 * u * (exact::length(p) + Real(extentOf(cone)));
        if (exact::abs(exactly.height(p)) > rounding) return "position off the cone";
        if (exactly.up(p) < -rounding || exactly.up(p) > exactly.slant + rounding)
            return "position beyond the ends";
        if (exact::distanceFromLine(hit.position, ray) > rounding + width)
            return "position off the ray";
        if (exact::abs(exact::length(normal) - 1) > 4 * u) return "normal not of unit length";
        if (dot(normal, d) > 4 * u * size) return "normal along the ray";
        const bool outside = hit.frontFacing && cone.baseRadius + cone.apexRadius > 0;
        const Real3 turned = (outside ? 1 : -1) * exactly.outwards(p);
        const Real turn = 2 * (rounding + width) / exactly.fromAxis(p) + 8 * u;
        if (exact::length(normal - turned) > turn) return "wrong normal";
        return "";
    }

    Ray ray;
    Cone cone;
    ExactCone exactly;
    Real size, delta;
    Expected entry, exit;
};

}  // namespace

TEST_CASE("a cone is hit where exact arithmetic says") {
    int hits = 0, insides = 0;
    checkRandomCases(8 * familySize, [&](Random& random) {
        const ConeCase c = randomConeCase(random);
        Intersection hit;
        const bool found = c.cone.intersect(c.ray, hit);
        hits += found;
        insides += found && c.cone.baseRadius + c.cone.apexRadius < 0;
        const Oracle oracle(c);
        const std::string problem = found ? oracle.judgeHit(hit) : oracle.judgeMiss();
        return problem.empty() ? problem : problem + " " + describe(c.ray, c.cone);
    });
    CHECK(hits > 2 * familySize);
    CHECK(insides > familySize / 4);
}
