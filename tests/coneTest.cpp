#include "swCone.h"

#include "support.h"

using namespace sw;
using namespace test;

namespace {

const Material paint({0.1f, 0.2f, 0.3f}, 0.4f, 0.5f, 1.6f);

Cone randomCone(Random& random) {
    Cone cone(random.point(10), random.real(0.1, 5), random.point(10), random.real(0.1, 5), paint);
    const int kind = random.whole(0, 3);
    if (kind == 0) cone.apexRadius = 0;
    if (kind == 1) cone.baseRadius = 0;
    if (kind == 2) cone.apexRadius = cone.baseRadius;
    return cone;
}

Cone turnedInside(const Cone& cone) {
    return {cone.base, -cone.baseRadius, cone.apex, -cone.apexRadius, cone.material};
}

// A point of the mantle by its definition.
dvec3 surfacePoint(Random& random, const Cone& cone, double up) {
    const dvec3 base = toDouble(cone.base), way = toDouble(cone.apex) - base;
    const dvec3 aside = glm::normalize(cross(way, toDouble(random.direction())));
    const double from = std::fabs(cone.baseRadius), to = std::fabs(cone.apexRadius);
    return base + up * way + (from + up * (to - from)) * aside;
}

}  // namespace

TEST_CASE("a cylinder is hit where the circle across it says") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const float r = random.real(0.5, 2);
    const Cone cylinder({0, 0, -1000}, r, {0, 0, 1000}, r, paint);
    const double x = random.uniform(-0.99, 0.99) * r, speed = random.uniform(0.1, 10);
    const double half = std::sqrt(r * r - x * x);
    const Ray ray({float(x), 10, random.real(-50, 50)}, {0, float(-speed), random.real(-1, 1)});
    Intersection hit;
    REQUIRE(cylinder.intersect(ray, hit));
    CHECK(std::fabs(hit.hitT - (10 - half) / speed) <= 1e-4);
    CHECK(distance(hit.normal, dvec3(x / r, half / r, 0)) <= 1e-4);
    CHECK(hit.frontFacing);
    REQUIRE(turnedInside(cylinder).intersect(ray, hit));
    CHECK(std::fabs(hit.hitT - (10 + half) / speed) <= 1e-4);
    CHECK(distance(hit.normal, dvec3(-x / r, half / r, 0)) <= 1e-4);
    CHECK(hit.frontFacing);
}

TEST_CASE("a cone with a slope of 45 degrees is hit at its known points") {
    const Cone cone({0, 0, 0}, 2, {0, 0, 2}, 0, paint);
    CHECK(hitT(cone, Ray({5, 0, 1}, {-1, 0, 0})) == 4);
    CHECK(hitT(cone, Ray({0, 0, 1}, {1, 0, 0})) == 1);
    CHECK(hitT(cone, Ray({0, 0, -3}, {0, 0, 1})) == 5);  // the tip, from inside
    CHECK(hitT(cone, Ray({1, 0, 5}, {0, 0, -1})) == 4);
    CHECK_FALSE(isHit(cone, Ray({1, 0, 0.5f}, {0, 0, -1})));  // out of the open base
    CHECK_FALSE(isHit(cone, Ray({5, 0, 3}, {-1, 0, 0})));     // the mirror image beyond the tip
    CHECK_FALSE(isHit(cone, Ray({5, 0, -1}, {-1, 0, 0})));
    Intersection hit;
    REQUIRE(cone.intersect(Ray({0, 0, -3}, {0, 0, 1}), hit));
    CHECK_FALSE(hit.frontFacing);
    CHECK(hit.normal * hit.ray.dir < 0);
}

TEST_CASE("a ray at a point of a cone meets it there or before, with negative radii from inside") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Cone cone = randomCone(random);
    const dvec3 point = surfacePoint(random, cone, random.uniform(0.1, 0.9));
    const dvec3 middle = (toDouble(cone.base) + toDouble(cone.apex)) * 0.5;
    const dvec3 away = glm::normalize(toDouble(random.direction()));
    const Vec3 from = num::toFloat(middle + 40.0 * away);
    const Ray ray(from, num::toFloat(point) - from);
    Intersection hit, inside;
    if (!cone.intersect(ray, hit)) return;  // the silhouette, missed by the ray's rounding
    CHECK(hit.hitT <= 1.01);
    CHECK(hit.normal * ray.dir <= 0);
    CHECK(std::fabs(glm::length(toDouble(hit.normal)) - 1) <= 1e-6);
    const bool found = turnedInside(cone).intersect(ray, inside);
    if (found) CHECK(inside.frontFacing);
    if (!hit.frontFacing) {
        REQUIRE(found);
        CHECK(inside.hitT == hit.hitT);
        CHECK(distance(inside.normal, hit.normal) == 0);
    } else if (found) {
        CHECK(inside.hitT >= hit.hitT);
    }
}

TEST_CASE("a ray along the axis finds the tip closed") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Vec3 tip = random.point(10);
    Intersection hit;
    REQUIRE(
        Cone({0, 0, 0}, random.real(0.1, 10), tip, 0, paint).intersect(Ray({0, 0, 0}, tip), hit));
    CHECK(hit.hitT == 1);
    CHECK_FALSE(hit.frontFacing);
    CHECK(hit.normal * tip < 0);
    CHECK(distance(hit.position, tip) <= 1e-5);
}

TEST_CASE("a cone scaled by a power of two is hit at the same t") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const Cone cone = randomCone(random);
    const Vec3 from = random.point(30);
    const Vec3 to = num::toFloat(surfacePoint(random, cone, 0.5));
    const float s = std::ldexp(1.0f, random.whole(-40, 40));
    const Cone scaled(cone.base * s, cone.baseRadius * s, cone.apex * s, cone.apexRadius * s,
                      paint);
    const float t = hitT(cone, Ray(from, to - from));
    const float same = hitT(scaled, Ray(from * s, (to - from) * s));
    CHECK((same == t || (std::isnan(same) && std::isnan(t))));
}

TEST_CASE("the box of a cone holds it and touches it on every side") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    const Cone cone = seed % 2 == 0 ? randomCone(random) : turnedInside(randomCone(random));
    const Bounds box = cone.bounds();
    CHECK(box.isFinite());
    dvec3 lowest(HUGE_VAL), highest(-HUGE_VAL);
    for (int i = 0; i < 4000; ++i) {
        const dvec3 p = surfacePoint(random, cone, i % 2);
        lowest = min(lowest, p);
        highest = max(highest, p);
    }
    for (int i = 0; i < 3; ++i) {
        CHECK(box.min[i] <= lowest[i]);
        CHECK(box.max[i] >= highest[i]);
    }
    CHECK(distance(box.min, lowest) <= 1e-3);
    CHECK(distance(box.max, highest) <= 1e-3);
}

TEST_CASE("a cone is hit strictly between minT and maxT") {
    const Cone cone({0, -1, 0}, 1, {0, 1, 0}, 1, paint);
    // Enters at t = 4 and leaves at t = 8.
    const auto within = [&](float minT, float maxT) {
        return hitT(cone, Ray({0, 0, 3}, {0, 0, -0.5f}, minT, maxT));
    };
    CHECK(within(0, FLT_MAX) == 4);
    CHECK(within(4, FLT_MAX) == 8);
    CHECK(within(-HUGE_VALF, HUGE_VALF) == 4);
    CHECK(std::isnan(within(0, 4)));
    CHECK(std::isnan(within(4, 8)));
    CHECK(std::isnan(within(8, FLT_MAX)));
}

TEST_CASE("a hit on a cone carries its material and the ray") {
    const Ray ray({0, 0, 5}, {0.5f, 0, -4}, 0.25f, 100, RayKind::refracted);
    Intersection hit;
    REQUIRE(Cone({0, -1, 0}, 1, {0, 1, 0}, 1, paint).intersect(ray, hit));
    CHECK(hit.material.refractiveIndex == paint.refractiveIndex);
    CHECK(distance(hit.ray.orig, ray.orig) == 0);
    CHECK(hit.ray.minT == ray.minT);
    CHECK(hit.ray.kind == ray.kind);
}

TEST_CASE("a cone with invalid numbers is never hit") {
    const Ray ray(GENERATE(Vec3(0.2f, 0, 5), Vec3(0, 0, 0.5f), Vec3(0, 0, 0)), {0.1f, 0, -1});
    const Vec3 low(0, -1, 0), high(0, 1, 0);
    REQUIRE(isHit(Cone(low, 1, high, 2, paint), ray));
    CHECK_FALSE(isHit(Cone(low, 1, low, 2, paint), ray));
    CHECK_FALSE(isHit(Cone(low, 0, high, 0, paint), ray));
    CHECK_FALSE(isHit(Cone(low, -1, high, 2, paint), ray));
    CHECK_FALSE(isHit(Cone(low, 1, high, -2, paint), ray));
    for (const float bad : {NAN, HUGE_VALF, -HUGE_VALF}) {
        CHECK_FALSE(isHit(Cone(low, bad, high, 2, paint), ray));
        CHECK_FALSE(isHit(Cone(low, 1, high, bad, paint), ray));
        for (int i = 0; i < 3; ++i) {
            Cone cone(low, 1, high, 2, paint);
            cone.base[i] = bad;
            CHECK_FALSE(isHit(cone, ray));
            Ray spoilt = ray;
            spoilt.orig[i] = bad;
            CHECK_FALSE(isHit(Cone(low, 1, high, 2, paint), spoilt));
            spoilt = ray;
            spoilt.dir[i] = bad;
            CHECK_FALSE(isHit(Cone(low, 1, high, 2, paint), spoilt));
        }
    }
    CHECK_FALSE(isHit(Cone(low, 1, high, 2, paint), Ray(ray.orig, {0, 0, 0})));
}
