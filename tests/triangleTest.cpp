#define GLM_ENABLE_EXPERIMENTAL
#include "swTriangle.h"

#include <glm/gtx/intersect.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

const Material paint({0.1f, 0.2f, 0.3f}, 0.4f, 0.5f, 1.6f);

Triangle triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 v[] = {a, b, c};
    return Triangle(v, paint);
}

dvec3 side(const Triangle& t, int i) {
    return toDouble(t.vertices[i]) - toDouble(t.vertices[0]);
}

dvec3 unitNormal(const Triangle& t) {
    return glm::normalize(cross(side(t, 1), side(t, 2)));
}

// In a cube of side 20. Not so small or thin that the textbook formula in floats goes wrong.
Triangle randomTriangle(Random& random) {
    for (;;) {
        const Vec3 corners[] = {random.point(10), random.point(10), random.point(10)};
        const Triangle t(corners, paint);
        const double a = glm::length(side(t, 1)), b = glm::length(side(t, 2));
        if (a > 4 && b > 4 && glm::length(cross(side(t, 1), side(t, 2))) > 0.3 * a * b) return t;
    }
}

// Barycentric coordinates: the point v0 + v (v1 - v0) + w (v2 - v0).
struct Spot {
    double v, w;
};

// Inside, clear of all edges by 1e-3; often near one.
Spot randomSpot(Random& random) {
    for (;;) {
        const double v = random.magnitude(1e-3, 1), w = random.magnitude(1e-3, 1);
        if (v + w > 0.999) continue;
        const int corner = random.whole(0, 2);
        return corner == 0 ? Spot{v, w} : corner == 1 ? Spot{1 - v - w, w} : Spot{v, 1 - v - w};
    }
}

// A ray from either side towards that spot, not too grazing. Its direction has any length.
Ray randomRay(Random& random, const Triangle& t, const Spot& spot) {
    const dvec3 target = toDouble(t.vertices[0]) + spot.v * side(t, 1) + spot.w * side(t, 2);
    Vec3 along = random.direction();
    while (std::fabs(dot(toDouble(along), unitNormal(t))) < 0.2) along = random.direction();
    const Vec3 origin = num::toFloat(target - random.uniform(1, 20) * toDouble(along));
    return Ray(origin, along * random.magnitude(0.01, 100));
}

// The ray parameter by GLM in double precision. It counts hits behind the origin as well.
std::optional<double> oracle(const Triangle& t, const Ray& ray) {
    glm::dvec2 spot;
    double parameter = 0;
    if (!glm::intersectRayTriangle(toDouble(ray.orig), toDouble(ray.dir), toDouble(t.vertices[0]),
                                   toDouble(t.vertices[1]), toDouble(t.vertices[2]), spot,
                                   parameter) ||
        parameter < 0)
        return {};
    return parameter;
}

Vec3 wholeVector(Random& random) {
    Vec3 v;
    for (float& x : v.m) x = static_cast<float>(random.whole(-8, 8));
    return v;
}

}  // namespace

TEST_CASE("a triangle is hit where double precision says") {
    const auto seed = GENERATE(range(0u, 2000u));
    CAPTURE(seed);
    Random random(seed);
    const Triangle t = randomTriangle(random);
    const Ray ray = randomRay(random, t, randomSpot(random));
    const auto expected = oracle(t, ray);
    REQUIRE(expected);

    Intersection hit;
    REQUIRE(t.intersect(ray, hit));
    CHECK(std::fabs(hit.hitT / *expected - 1) <= 1e-4);
    const dvec3 p = toDouble(ray.orig) + *expected * toDouble(ray.dir);
    CHECK(distance(hit.position, p) <= 1e-3);  // 1e-4 of the lengths involved
    const dvec3 n = unitNormal(t);
    const bool front = dot(n, toDouble(ray.dir)) < 0;
    CHECK(hit.frontFacing == front);
    CHECK(distance(hit.normal, front ? n : -n) <= 1e-4);
    CHECK(std::fabs(glm::length(toDouble(hit.normal)) - 1) <= 1e-6);
    CHECK(hit.normal * ray.dir < 0);
}

// (-v, w), (v, -w) and (-v, -w) are the places where |v| + |w| < 1 although they lie outside: areas
// measured by norms, without their signs, accept them.
TEST_CASE("points beyond any edge or corner of a triangle are not hit") {
    const auto seed = GENERATE(range(0u, 1000u));
    Random random(seed);
    const Triangle t = randomTriangle(random);
    const auto [v, w] = randomSpot(random);
    for (const Spot& spot : {Spot{-v, w}, Spot{v, -w}, Spot{-v, -w}, Spot{1 - v, 1 - w},
                             Spot{1 + v, -w}, Spot{-v, 1 + w}, Spot{1 + v, 1 + w}}) {
        CAPTURE(seed, spot.v, spot.w);
        const Ray ray = randomRay(random, t, spot);
        REQUIRE_FALSE(oracle(t, ray));
        CHECK_FALSE(isHit(t, ray));
    }
}

TEST_CASE("a triangle behind the ray is not hit") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Triangle t = randomTriangle(random);
    const Ray ray = randomRay(random, t, randomSpot(random));
    CHECK(isHit(t, ray));
    CHECK_FALSE(isHit(t, Ray(ray.orig, -ray.dir)));
}

TEST_CASE("exchanging two vertices turns a triangle round") {
    const Ray ray({1, 1, 5}, {0, 0, -2});
    Intersection hit;
    REQUIRE(triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}).intersect(ray, hit));
    CHECK(hit.frontFacing);
    CHECK(distance(hit.normal, Vec3(0, 0, 1)) <= 1e-6);
    REQUIRE(triangle({0, 0, 0}, {0, 4, 0}, {4, 0, 0}).intersect(ray, hit));
    CHECK_FALSE(hit.frontFacing);
    CHECK(distance(hit.normal, Vec3(0, 0, 1)) <= 1e-6);
}

TEST_CASE("a hit on a triangle carries its material and the ray") {
    Triangle t = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    static_cast<Primitive&>(t).material.reflectivity = 0.25f;
    const Ray ray({1, 1, 5}, {0.1f, 0, -2}, 0.5f, 50, RayKind::reflected);
    Intersection hit;
    REQUIRE(t.intersect(ray, hit));
    CHECK(distance(hit.material.color, paint.color) == 0);
    CHECK(hit.material.reflectivity == 0.25f);
    CHECK(hit.material.refractiveIndex == paint.refractiveIndex);
    CHECK((distance(hit.ray.orig, ray.orig) == 0 && distance(hit.ray.dir, ray.dir) == 0));
    CHECK((hit.ray.minT == ray.minT && hit.ray.maxT == ray.maxT && hit.ray.kind == ray.kind));
}

TEST_CASE("a triangle is hit strictly between minT and maxT") {
    const Triangle t = triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
    // Meets the triangle at t = 4.
    const auto within = [&](float minT, float maxT) {
        return isHit(t, Ray({1, 1, 2}, {0, 0, -0.5f}, minT, maxT));
    };
    CHECK(within(0, FLT_MAX));
    CHECK(within(3.999f, 4.001f));
    CHECK(within(-HUGE_VALF, HUGE_VALF));
    CHECK_FALSE(within(0, 3.999f));
    CHECK_FALSE(within(0, 4));
    CHECK_FALSE(within(4, FLT_MAX));
    CHECK_FALSE(within(4.001f, FLT_MAX));
    CHECK_FALSE(within(5, 3));
    CHECK(isHit(t, Ray({1, 1, 2}, {0, 0, 1}, -3)));
    CHECK_FALSE(isHit(t, Ray({1, 1, 2}, {0, 0, 1}, -1)));
}

TEST_CASE("a triangle keeps its own vertices") {
    auto v = std::make_unique<Vec3[]>(6);
    v[4] = Vec3(4, 0, 0);
    v[5] = Vec3(0, 4, 0);
    auto original = std::make_unique<Triangle>(&v[3], paint);
    v[3] = v[4] = v[5] = Vec3(NAN, NAN, NAN);
    v.reset();
    const Ray ray({1, 1, 5}, {0, 0, -1});
    CHECK(isHit(*original, ray));
    const Triangle copy = *original;
    original->vertices[0] = Vec3(100, 100, 100);
    original.reset();
    CHECK(isHit(copy, ray));
}

// Whole numbers keep every product exact, in floats as well.
TEST_CASE("a ray in the plane of a triangle or parallel to it is no hit") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const Vec3 v0 = wholeVector(random), e1 = wholeVector(random), e2 = wholeVector(random);
    const int i = random.whole(-3, 3), j = random.whole(-3, 3), k = random.whole(-2, 2);
    const Vec3 n = e1 % e2, along = e1 * i + e2 * j;
    if (n * n == 0 || along * along == 0) return;
    const Triangle t = triangle(v0, v0 + e1, v0 + e2);
    const Vec3 inPlane = v0 + e1 * k + e2 * (i - k);
    CHECK_FALSE(isHit(t, Ray(inPlane, along)));
    CHECK_FALSE(isHit(t, Ray(inPlane, along, -FLT_MAX, HUGE_VALF)));
    CHECK_FALSE(isHit(t, Ray(inPlane + n, along, -FLT_MAX, HUGE_VALF)));
}

TEST_CASE("a triangle of zero area is never hit") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Vec3 a = wholeVector(random), e = wholeVector(random), b = a + e * 2, c = a + e;
    const Vec3 origin = wholeVector(random);
    for (const Vec3& target : {a, b, c}) {
        const Ray ray(origin, target - origin);
        CHECK_FALSE(isHit(triangle(a, a, a), ray));
        CHECK_FALSE(isHit(triangle(a, a, b), ray));
        CHECK_FALSE(isHit(triangle(a, b, a), ray));
        CHECK_FALSE(isHit(triangle(b, a, a), ray));
        CHECK_FALSE(isHit(triangle(a, b, c), ray));
    }
}

TEST_CASE("numbers that are not finite never make a hit on a triangle") {
    const Triangle sound = triangle({-3, -4, 1}, {5, -2, -1}, {0.5f, 6, 2});
    const Ray straight({1, 0.25f, 10}, {-0.1f, 0.05f, -1});
    REQUIRE(isHit(sound, straight));
    const float bad = GENERATE(NAN, HUGE_VALF, -HUGE_VALF);
    for (int i = 0; i < 3; ++i) {
        Ray ray = straight;
        ray.orig[i] = bad;
        CAPTURE(bad, i);
        CHECK_FALSE(isHit(sound, ray));
        ray = straight;
        ray.dir[i] = bad;
        CHECK_FALSE(isHit(sound, ray));
        for (int k = 0; k < 3; ++k) {
            Triangle t = sound;
            t.vertices[k][i] = bad;
            CHECK_FALSE(isHit(t, straight));
        }
    }
    CHECK_FALSE(isHit(sound, Ray(straight.orig, straight.dir, NAN)));
    CHECK_FALSE(isHit(sound, Ray(straight.orig, straight.dir, 0, NAN)));
    CHECK_FALSE(isHit(sound, Ray(straight.orig, {0, 0, 0})));
}
