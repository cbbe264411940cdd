// A ray that leaves a sphere outwards never meets it again; one that goes inwards meets it once
// more, from inside. The exact oracle asks on which side of the sphere the spawned ray starts, and
// how close the exact segment from there to the light comes to the centre. Only where that is
// within shadowMargin of the radius may the answer be either.

#include "stability/spawn.h"
#include "stability/sphereCases.h"

using namespace sw;
using namespace test;
using exact::Real;
using exact::Real3;

namespace {

SphereCase randomDeparture(Random& random) {
    SphereCase c;
    c.sphere = Sphere({0, 0, 0}, random.magnitude(1e-3, 1e3), anyGlass(random));
    if (random.coin())
        c.sphere.center = random.direction() * (c.sphere.radius * random.magnitude(0.1, 1e4));
    const int kind = random.whole(0, 3);
    c.ray = kind == 0   ? tangent(random, c.sphere)
            : kind == 1 ? fromWithin(random, c.sphere)
                        : fromAfar(random, c.sphere);
    const float scale = anyScale(random);
    c.sphere.center *= scale;
    c.sphere.radius *= scale;
    c.ray.orig *= scale;
    return c;
}

bool startsOutside(const Sphere& sphere, const Ray& ray) {
    const Real3 f = Real3(ray.orig) - Real3(sphere.center);
    return dot(f, f) > Real(sphere.radius) * Real(sphere.radius);
}

std::string judgeSpawned(const Sphere& sphere, const Intersection& hit, const Ray& ray,
                         bool outwards) {
    Intersection next;
    const bool hits = sphere.intersect(ray, next);
    if (startsOutside(sphere, ray) != outwards) return "starts on the wrong side";
    if (!startsNear(ray, hit, 2 * static_cast<double>(sphere.radius))) return "starts too far off";
    if (outwards && hits) return describe("hits again at", next.hitT);
    if (!outwards && !hits) return "finds no way out";
    if (!outwards && next.frontFacing) return "is inside but hits the front";
    return "";
}

Vec3 anyLight(Random& random, const Sphere& sphere) {
    return moved(sphere.center, random.direction(), sphere.radius * random.magnitude(0.1, 100));
}

// -1: the exact segment is free, 1: the sphere blocks it, 0: too close to call.
int blocked(const Sphere& sphere, const Intersection& hit, const Vec3& light) {
    const Real3 from = Real3(hit.getShadowRay(light).orig) - Real3(sphere.center);
    const Real3 to = Real3(light) - Real3(sphere.center), way = to - from;
    const Real r = sphere.radius, margin = shadowMargin(hit, light, sphere.radius);
    if (!hit.frontFacing) {
        const Real beyond = exact::length(to) - r;
        return beyond > margin ? 1 : beyond < -margin ? -1 : 0;
    }
    const Real rise = dot(from, way) / exact::length(from);
    if (rise > margin) return -1;  // the light is above the horizon
    const Real nearest = exact::min(1, exact::max(0, -dot(from, way) / dot(way, way)));
    return exact::length(from + nearest * way) < r - margin ? 1 : 0;
}

}  // namespace

TEST_CASE("a ray that leaves a sphere hits it only where it should") {
    int inwards = 0, outwards = 0;
    checkRandomCases(2 * familySize, [&](Random& random) {
        const SphereCase c = randomDeparture(random);
        Intersection hit;
        if (!c.sphere.intersect(c.ray, hit)) return std::string();
        const Ray reflected = hit.getReflectedRay(), refracted = hit.getRefractedRay();
        const bool staysOutside = hit.frontFacing;
        const bool entersOutside = isTotal(refracted, hit) ? staysOutside : !staysOutside;
        (entersOutside ? outwards : inwards)++;
        std::string problem = judgeSpawned(c.sphere, hit, reflected, staysOutside);
        if (!problem.empty()) return "reflected: " + problem + describe(c.ray, c.sphere);
        problem = judgeSpawned(c.sphere, hit, refracted, entersOutside);
        if (!problem.empty())
            return "refracted: " + problem +
                   describe(c.ray, c.sphere, c.sphere.material.refractiveIndex);
        return std::string();
    });
    CHECK(inwards > familySize / 4);
    CHECK(outwards > familySize / 4);
}

TEST_CASE("a sphere blocks the light behind it and no other") {
    int count[3] = {0, 0, 0};
    checkRandomCases(2 * familySize, [&](Random& random) {
        const SphereCase c = randomDeparture(random);
        Intersection hit, blocker;
        if (!c.sphere.intersect(c.ray, hit)) return std::string();
        const Vec3 light = anyLight(random, c.sphere);
        const int expected = blocked(c.sphere, hit, light);
        ++count[expected + 1];
        const bool found = c.sphere.intersect(hit.getShadowRay(light), blocker);
        if (expected == 0 || found == (expected > 0)) return std::string();
        return describe(found ? "blocked" : "not blocked", c.ray, c.sphere, "light", light);
    });
    CHECK(count[0] > familySize / 4);
    CHECK(count[2] > familySize / 4);
}
