#define GLM_ENABLE_EXPERIMENTAL
#include "swSphere.h"

#include <glm/gtx/intersect.hpp>
#include <optional>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

const Material paint({0.1f, 0.2f, 0.3f}, 0.4f, 0.5f, 1.6f);

enum class Start { outside, inside, beyond };  // beyond: the sphere lies behind the ray

Sphere randomSphere(Random& random) {
    return {random.point(10), random.magnitude(0.1, 10), paint};
}

// A ray whose line passes the centre at `miss` radii, starting a hundredth of the radius or more
// away from the surface. Its direction has any length.
Ray randomRay(Random& random, const Sphere& sphere, double miss, Start start) {
    const double r = sphere.radius;
    const dvec3 along = toDouble(random.direction());
    const dvec3 aside = glm::normalize(cross(along, toDouble(random.direction())));
    const double halfChord = std::sqrt(std::max(0.0, 1 - miss * miss));
    double before = halfChord + random.uniform(0.01, 20);
    if (start == Start::inside) before = random.uniform(0.01 - halfChord, halfChord - 0.01);
    if (start == Start::beyond) before = -before;
    const dvec3 origin = toDouble(sphere.center) + miss * r * aside - before * r * along;
    return Ray(num::toFloat(origin), num::toFloat(along) * random.magnitude(0.01, 100));
}

// Distance to the hit by GLM in double precision. It takes unit directions only.
std::optional<double> oracle(const Sphere& sphere, const Ray& ray) {
    const double r = sphere.radius;
    double away = 0;
    if (!glm::intersectRaySphere(toDouble(ray.orig), glm::normalize(toDouble(ray.dir)),
                                 toDouble(sphere.center), r * r, away))
        return {};
    return away;
}

}  // namespace

TEST_CASE("a sphere is hit where double precision says") {
    const auto start = GENERATE(Start::outside, Start::inside);
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(start, seed);
    Random random(seed);
    const Sphere sphere = randomSphere(random);
    const Ray ray = randomRay(random, sphere, random.uniform(0, 0.99), start);
    const auto expected = oracle(sphere, ray);
    REQUIRE(expected);

    Intersection hit;
    REQUIRE(sphere.intersect(ray, hit));
    const double speed = glm::length(toDouble(ray.dir));
    const dvec3 p = toDouble(ray.orig) + *expected / speed * toDouble(ray.dir);
    const dvec3 outward = (p - toDouble(sphere.center)) / static_cast<double>(sphere.radius);
    CHECK(std::fabs(hit.hitT * speed - *expected) <= 1e-4 * *expected);
    CHECK(distance(hit.position, p) <= 1e-4 * sphere.radius);
    CHECK(hit.frontFacing == (start == Start::outside));
    CHECK(distance(hit.normal, start == Start::outside ? outward : -outward) <= 1e-4);
}

TEST_CASE("the normal of a sphere has length 1 and is turned against the ray") {
    const auto start = GENERATE(Start::outside, Start::inside);
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(start, seed);
    Random random(seed);
    const Sphere sphere = randomSphere(random);
    const Ray ray = randomRay(random, sphere, random.uniform(0, 0.99), start);
    Intersection hit;
    REQUIRE(sphere.intersect(ray, hit));
    CHECK(std::fabs(glm::length(toDouble(hit.normal)) - 1) <= 1e-6);
    CHECK(hit.normal * ray.dir < 0);
}

TEST_CASE("a hit on a sphere carries its material and the ray") {
    Ray ray({0, 0, 5}, {0.5f, 0, -4}, 0.25f, 100);
    ray.kind = RayKind::refracted;
    Intersection hit;
    REQUIRE(Sphere({0, 0, 0}, 2, paint).intersect(ray, hit));
    CHECK(distance(hit.material.color, paint.color) == 0);
    CHECK(hit.material.reflectivity == paint.reflectivity);
    CHECK(hit.material.transparency == paint.transparency);
    CHECK(hit.material.refractiveIndex == paint.refractiveIndex);
    CHECK(distance(hit.ray.orig, ray.orig) == 0);
    CHECK(distance(hit.ray.dir, ray.dir) == 0);
    CHECK(hit.ray.minT == ray.minT);
    CHECK(hit.ray.maxT == ray.maxT);
    CHECK(hit.ray.kind == ray.kind);
}

TEST_CASE("the material of a sphere can be changed through its base class") {
    Sphere sphere({0, 0, 0}, 1, paint);
    static_cast<Primitive&>(sphere).material.color = Color(1, 0, 0);
    Intersection hit;
    REQUIRE(sphere.intersect(Ray({0, 0, 5}, {0, 0, -1}), hit));
    CHECK(distance(hit.material.color, Color(1, 0, 0)) == 0);
}

TEST_CASE("rays that pass a sphere or leave it behind miss it") {
    const auto start = GENERATE(Start::outside, Start::beyond);
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(start, seed);
    Random random(seed);
    const Sphere sphere = randomSphere(random);
    CHECK_FALSE(isHit(sphere, randomRay(random, sphere, random.uniform(1.01, 5), start)));
    CHECK_FALSE(isHit(sphere, randomRay(random, sphere, random.uniform(0, 0.99), Start::beyond)));
}

TEST_CASE("a longer direction meets the sphere at a smaller t in the same place") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const Sphere sphere = randomSphere(random);
    const Ray ray = randomRay(random, sphere, random.uniform(0, 0.99), Start::outside);
    const float factor = random.magnitude(1e-6, 1e6);
    Intersection hit, scaled;
    REQUIRE(sphere.intersect(ray, hit));
    REQUIRE(sphere.intersect(Ray(ray.orig, ray.dir * factor), scaled));
    CHECK(std::fabs(scaled.hitT * factor / hit.hitT - 1) <= 1e-4);
    CHECK(distance(scaled.position, hit.position) <= 1e-4 * sphere.radius);
}

TEST_CASE("a sphere with a negative radius is seen only from inside, as its front") {
    const auto start = GENERATE(Start::outside, Start::inside);
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(start, seed);
    Random random(seed);
    const Sphere sphere = randomSphere(random);
    const Sphere inside(sphere.center, -sphere.radius, paint);
    Ray ray = randomRay(random, sphere, random.uniform(0, 0.99), start);
    Intersection hit, expected;
    REQUIRE(inside.intersect(ray, hit));
    REQUIRE(sphere.intersect(ray, expected));
    if (expected.frontFacing) ray.minT = expected.hitT;  // its inside comes next
    REQUIRE(sphere.intersect(ray, expected));
    CHECK_FALSE(expected.frontFacing);
    CHECK(hit.frontFacing);
    CHECK(hit.hitT == expected.hitT);
    CHECK(distance(hit.position, expected.position) == 0);
    CHECK(distance(hit.normal, expected.normal) == 0);
    CHECK(hit.positionError == expected.positionError);
    CHECK(distance(inside.bounds().min, sphere.bounds().min) == 0);
    CHECK(distance(inside.bounds().max, sphere.bounds().max) == 0);
}

TEST_CASE("a sphere is hit strictly between minT and maxT") {
    const Sphere sphere({0, 0, 0}, 1, paint);
    // Enters at t = 4 and leaves at t = 8.
    const auto within = [&](float minT, float maxT) {
        return hitT(sphere, Ray({0, 0, 3}, {0, 0, -0.5f}, minT, maxT));
    };
    CHECK(within(0, FLT_MAX) == 4);
    CHECK(within(3.999f, 4.001f) == 4);
    CHECK(within(4.001f, FLT_MAX) == 8);
    CHECK(within(4, FLT_MAX) == 8);
    CHECK(within(4, 8.001f) == 8);
    CHECK(within(-HUGE_VALF, HUGE_VALF) == 4);
    CHECK(std::isnan(within(0, 4)));
    CHECK(std::isnan(within(0, 3.999f)));
    CHECK(std::isnan(within(4, 8)));
    CHECK(std::isnan(within(4.001f, 7.999f)));
    CHECK(std::isnan(within(8, FLT_MAX)));
    CHECK(std::isnan(within(5, 3)));
}

TEST_CASE("a negative minT reaches behind the origin") {
    const Sphere sphere({0, 0, 0}, 1, paint);
    CHECK(hitT(sphere, Ray({0, 0, 0}, {0, 0, 1}, -5)) == -1);
    CHECK(hitT(sphere, Ray({0, 0, 0}, {0, 0, 1}, -0.5f)) == 1);
    CHECK(hitT(sphere, Ray({0, 0, 3}, {0, 0, 1}, -3)) == -2);
}

TEST_CASE("a ray with a number that is not finite never hits a sphere") {
    const Sphere sphere({1, 2, 3}, 5, paint);
    const Ray good(GENERATE(Vec3(10, 11, 12), Vec3(1.5f, 2, 3)), {-1, -1.1f, -0.9f});
    REQUIRE(isHit(sphere, good));
    const float bad = GENERATE(NAN, HUGE_VALF, -HUGE_VALF);
    CAPTURE(bad);
    for (int i = 0; i < 3; ++i) {
        Ray ray = good;
        ray.orig[i] = bad;
        CHECK_FALSE(isHit(sphere, ray));
        ray = good;
        ray.dir[i] = bad;
        CHECK_FALSE(isHit(sphere, ray));
    }
    CHECK_FALSE(isHit(sphere, Ray(good.orig, good.dir, NAN)));
    CHECK_FALSE(isHit(sphere, Ray(good.orig, good.dir, 0, NAN)));
    CHECK_FALSE(isHit(sphere, Ray(good.orig, {0, 0, 0})));
}

TEST_CASE("a sphere with invalid numbers is never hit") {
    const Ray ray(GENERATE(Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(0.5f, 0, 0)), {0, 0, -1});
    CHECK_FALSE(isHit(Sphere({0, 0, 0}, GENERATE(0.0f, NAN, HUGE_VALF, -HUGE_VALF), paint), ray));
    for (const float bad : {NAN, HUGE_VALF, -HUGE_VALF}) {
        CHECK_FALSE(isHit(Sphere({bad, 0, 0}, 1, paint), ray));
        CHECK_FALSE(isHit(Sphere({0, bad, 0}, 1, paint), ray));
        CHECK_FALSE(isHit(Sphere({0, 0, bad}, 1, paint), ray));
    }
}
