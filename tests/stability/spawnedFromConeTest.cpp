// A ray that leaves the outside of a cone never meets it again: a cone is convex, and the rays
// start outside of its exact surface. One that goes inwards starts inside and next meets the
// inside, or leaves through an open end. Where the cone is thinner than the step off its surface
// there is no inside to start in.

#include "stability/coneCases.h"
#include "stability/spawn.h"

using namespace sw;
using namespace test;
using exact::Real;
using exact::Real3;

namespace {

ConeCase randomDeparture(Random& random) {
    ConeCase c{randomCone(random, true), {}};
    c.cone.material = anyGlass(random);
    c.ray = randomRay(random, c.cone);
    return c;
}

// How far a point lies outside of the endless mantle.
Real height(const Cone& cone, const Vec3& point) {
    const Real3 base(cone.base), way = Real3(cone.apex) - base, n = exact::unit(way), p(point);
    const Real z = dot(p - base, n), length = exact::length(way);
    const Real growth = Real(cone.apexRadius) - Real(cone.baseRadius);
    const Real radius = Real(cone.baseRadius) + growth * z / length;
    const Real slant = exact::root(length * length + growth * growth);
    return (exact::length(p - base - z * n) - radius) * length / slant;
}

std::string judgeSpawned(const Cone& cone, const Intersection& hit, const Ray& ray, bool outwards) {
    Intersection next;
    const bool hits = cone.intersect(ray, next);
    if ((height(cone, ray.orig) > 0) != outwards) return "starts on the wrong side";
    if (!startsNear(ray, hit, extentOf(cone))) return "starts too far off";
    if (outwards && hits) return describe("hits again at", next.hitT);
    if (!outwards && hits && next.frontFacing) return "is inside but hits the front";
    return "";
}

// Whether the inside is wide enough to hold the points that rays start from.
bool hasRoom(const Cone& cone, const Intersection& hit) {
    return height(cone, moved(hit.position, hit.frontFacing ? -hit.normal : hit.normal,
                              4.0 * hit.positionError)) < -hit.positionError;
}

// Whether the cone is thinner there than the position's error.
bool isTip(const Cone& cone, const Intersection& hit) {
    const Real3 base(cone.base), n = exact::unit(Real3(cone.apex) - base), p(hit.position);
    return exact::length(p - base - dot(p - base, n) * n) < Real(hit.positionError);
}

}  // namespace

TEST_CASE("a ray that leaves a cone hits it only where it should") {
    int inwards = 0, outwards = 0;
    checkRandomCases(4 * familySize, [&](Random& random) {
        const ConeCase c = randomDeparture(random);
        Intersection hit;
        if (!c.cone.intersect(c.ray, hit)) return std::string();
        if (isTip(c.cone, hit)) return std::string();
        const bool room = hasRoom(c.cone, hit);
        const Ray reflected = hit.getReflectedRay(), refracted = hit.getRefractedRay();
        const bool staysOutside = hit.frontFacing;
        const bool entersOutside = isTotal(refracted, hit) ? staysOutside : !staysOutside;
        (entersOutside ? outwards : inwards)++;
        std::string problem;
        if (staysOutside || room) problem = judgeSpawned(c.cone, hit, reflected, staysOutside);
        if (!problem.empty()) return "reflected: " + problem + " " + describe(c.ray, c.cone);
        if (entersOutside || room) problem = judgeSpawned(c.cone, hit, refracted, entersOutside);
        if (!problem.empty()) return "refracted: " + problem + " " + describe(c.ray, c.cone);
        return std::string();
    });
    CHECK(inwards > familySize / 4);
    CHECK(outwards > familySize / 4);
}

TEST_CASE("the outside of a cone is lit by every light above its horizon") {
    int lit = 0;
    checkRandomCases(2 * familySize, [&](Random& random) {
        const ConeCase c = randomDeparture(random);
        Intersection hit, blocker;
        if (!c.cone.intersect(c.ray, hit) || !hit.frontFacing) return std::string();
        const double away = extentOf(c.cone) * random.magnitude(0.1, 100);
        const Vec3 light = moved(hit.position, random.direction(), away);
        const Ray shadow = hit.getShadowRay(light);
        const double rise = dot(toDouble(shadow.dir), toDouble(hit.normal));
        if (!(rise > double(shadowMargin(hit, light, extentOf(c.cone))))) return std::string();
        ++lit;
        if (!c.cone.intersect(shadow, blocker)) return std::string();
        return describe("blocked", c.ray, c.cone, "light", light);
    });
    CHECK(lit > familySize / 4);
}
