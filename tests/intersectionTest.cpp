#include "swIntersection.h"

#include "support.h"
#include "swSphere.h"
#include "swTriangle.h"

using namespace sw;
using namespace test;

namespace {

dvec3 unit(const Vec3& v) {
    return glm::normalize(toDouble(v));
}

// A hit somewhere in the lab's dimensions, by a ray of any length that comes from either side.
Intersection randomHit(Random& random) {
    Intersection hit;
    hit.position = random.point(10);
    hit.normal = random.direction();
    Vec3 along = random.direction();
    while (std::fabs(along * hit.normal) < 0.02) along = random.direction();
    if (along * hit.normal > 0) along = -along;
    const float way = random.real(0.1, 20), speed = random.magnitude(0.01, 100);
    hit.ray = Ray(hit.position - way * along, along * speed);
    hit.hitT = way / speed;
    hit.frontFacing = random.coin();
    hit.material = Material({1, 1, 1}, 0.5f, 0.5f, random.magnitude(0.4, 2.5));
    return hit;
}

// What Snell's law divides the incoming sine by, as a factor.
double ratio(const Intersection& hit) {
    const double index = hit.material.refractiveIndex;
    return hit.frontFacing ? 1 / index : index;
}

double sine(const Vec3& direction, const Vec3& normal) {
    return glm::length(cross(unit(direction), unit(normal)));
}

// Random hits that are clearly refracted (or clearly not): the outgoing cosine's square is at
// least 1e-3 away from 0.
Intersection randomRefraction(Random& random, bool total) {
    for (;;) {
        const Intersection hit = randomHit(random);
        const double outgoing = sine(hit.ray.dir, hit.normal) * ratio(hit);
        const double c = 1 - outgoing * outgoing;
        if (total ? c < -1e-3 : c > 1e-3) return hit;
    }
}

// How far above the surface a ray begins. Negative: below it.
double height(const Ray& ray, const Intersection& hit) {
    const dvec3 start = toDouble(ray.orig) + static_cast<double>(ray.minT) * toDouble(ray.dir);
    return dot(start - toDouble(hit.position), toDouble(hit.normal));
}

double length(const Vec3& v) {
    return glm::length(toDouble(v));
}

}  // namespace

TEST_CASE("a reflected ray agrees with double precision") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomHit(random);
    const Ray ray = hit.getReflectedRay();
    CHECK(distance(ray.dir, glm::reflect(unit(hit.ray.dir), unit(hit.normal))) <= 1e-4);
    CHECK(std::fabs(length(ray.dir) - 1) <= 1e-5);
    CHECK(ray.dir * hit.normal > 0);
}

TEST_CASE("a refracted ray agrees with double precision") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, false);
    CAPTURE(hit.frontFacing, hit.material.refractiveIndex);
    const Ray ray = hit.getRefractedRay();
    CHECK(distance(ray.dir, glm::refract(unit(hit.ray.dir), unit(hit.normal), ratio(hit))) <= 1e-4);
    CHECK(std::fabs(length(ray.dir) - 1) <= 1e-4);
}

TEST_CASE("refraction obeys the law of Snell") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, false);
    const Ray ray = hit.getRefractedRay();
    const double index = hit.material.refractiveIndex;
    const double before = hit.frontFacing ? 1 : index, after = hit.frontFacing ? index : 1;
    CHECK(std::fabs(before * sine(hit.ray.dir, hit.normal) - after * sine(ray.dir, hit.normal)) <=
          1e-4 * index);
    CHECK(ray.dir * hit.normal < 0);
    const dvec3 plane = cross(unit(hit.ray.dir), unit(hit.normal));
    CHECK(std::fabs(dot(unit(ray.dir), plane)) <= 1e-4);
}

TEST_CASE("total internal reflection takes the reflected direction") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, true);
    const Ray ray = hit.getRefractedRay();
    CHECK(distance(ray.dir, glm::reflect(unit(hit.ray.dir), unit(hit.normal))) <= 1e-4);
    CHECK(std::fabs(length(ray.dir) - 1) <= 1e-5);
    CHECK(height(ray, hit) > 0);
}

TEST_CASE("entering glass bends a ray towards the normal and leaving it away from there") {
    Intersection hit;
    hit.normal = Vec3(0, 1, 0);
    hit.ray = Ray({-3, 4, 0}, {3, -4, 0});  // sine 0.6
    hit.hitT = 1;
    hit.material.refractiveIndex = 1.5f;
    CHECK(std::fabs(hit.getRefractedRay().dir[0] - 0.4f) <= 1e-5f);
    hit.frontFacing = false;
    CHECK(std::fabs(hit.getRefractedRay().dir[0] - 0.9f) <= 1e-5f);
    hit.material.refractiveIndex = 2;  // 1.2: total
    CHECK(distance(hit.getRefractedRay().dir, dvec3(0.6, 0.8, 0)) <= 1e-5);
}

TEST_CASE("a ray along the normal or into the same medium is not bent") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    Intersection hit = randomHit(random);
    hit.material.refractiveIndex = 1;
    CHECK(distance(hit.getRefractedRay().dir, unit(hit.ray.dir)) <= 1e-4);
    hit.material.refractiveIndex = random.magnitude(0.4, 2.5);
    hit.ray.dir = hit.normal * -random.magnitude(0.01, 100);
    CHECK(distance(hit.getRefractedRay().dir, -unit(hit.normal)) <= 1e-4);
    CHECK(distance(hit.getReflectedRay().dir, unit(hit.normal)) <= 1e-4);
}

TEST_CASE("the length of the incoming direction does not matter") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, random.coin());
    Intersection scaled = hit;
    const float factor = random.magnitude(1e-3, 1e3);
    scaled.ray.dir *= factor;
    scaled.hitT /= factor;
    CHECK(distance(scaled.getReflectedRay().dir, hit.getReflectedRay().dir) <= 1e-4);
    CHECK(distance(scaled.getRefractedRay().dir, hit.getRefractedRay().dir) <= 1e-4);
}

TEST_CASE("spawned rays start next to the hit point on the side they go to") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, false);
    const Vec3 light = random.point(20);
    const Ray shadow = hit.getShadowRay(light), reflected = hit.getReflectedRay(),
              refracted = hit.getRefractedRay();
    CHECK(dot(toDouble(shadow.orig) - toDouble(hit.position), toDouble(hit.normal)) > 0);
    CHECK(height(reflected, hit) > 0);
    CHECK(height(refracted, hit) < 0);
    for (const Ray& ray : {shadow, reflected, refracted})
        CHECK(distance(ray.orig, hit.position) < 0.02);
}

TEST_CASE("spawned rays begin at t 0 and only the shadow ray ends") {
    const auto seed = GENERATE(range(0u, 20u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomRefraction(random, random.coin());
    const Ray shadow = hit.getShadowRay(random.point(20)), reflected = hit.getReflectedRay(),
              refracted = hit.getRefractedRay();
    for (const Ray& ray : {shadow, reflected, refracted}) CHECK(ray.minT == 0);
    CHECK(shadow.maxT == 1 - 0x1p-22f);
    CHECK(shadow.kind == RayKind::shadow);
    CHECK(reflected.maxT == FLT_MAX);
    CHECK(refracted.maxT == FLT_MAX);
}

TEST_CASE("a shadow ray reaches from the surface to just short of the light") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Intersection hit = randomHit(random);
    const float away = random.real(2, 20);
    const Vec3 light = hit.position + away * random.direction();
    const Ray ray = hit.getShadowRay(light);
    CHECK(distance(ray.orig + ray.dir, light) <= 1e-5);
    const dvec3 way = unit(ray.dir);
    Intersection blocker;
    const Sphere before(num::toFloat(toDouble(light) - 0.6 * way), 0.5f, {});
    const Sphere behind(num::toFloat(toDouble(light) + 0.6 * way), 0.5f, {});
    CHECK(before.intersect(ray, blocker));
    CHECK_FALSE(behind.intersect(ray, blocker));
}

TEST_CASE("a surface shadows itself only from light behind it") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Sphere sphere{random.point(10), random.real(1, 5), {}};
    const Vec3 out = random.direction();
    Intersection hit, self;
    REQUIRE(sphere.intersect(Ray(sphere.center + 20 * out, -out), hit));
    CHECK(sphere.intersect(hit.getShadowRay(sphere.center - 20 * out), self));
    CHECK_FALSE(sphere.intersect(hit.getShadowRay(sphere.center + 15 * out), self));
    CHECK_FALSE(sphere.intersect(hit.getReflectedRay(), self));

    const Vec3 corners[] = {{-5, 0, -5}, {5, 0, -5}, {0, 0, 8}};
    const Triangle floor(corners, {});
    const float up = random.coin() ? 3.0f : -3.0f;
    REQUIRE(floor.intersect(Ray({0, up, 0}, {random.real(-1, 1), -up, 0}), hit));
    CHECK(floor.intersect(hit.getShadowRay({random.real(-1, 1), -up, 0}), self));
    CHECK_FALSE(floor.intersect(hit.getShadowRay({random.real(-9, 9), up, 0}), self));
    CHECK_FALSE(floor.intersect(hit.getReflectedRay(), self));
    CHECK_FALSE(floor.intersect(hit.getRefractedRay(), self));
}

TEST_CASE("a ray crosses a glass sphere and leaves it on its other side") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Sphere sphere{random.point(10), 3, {{1, 1, 1}, 0, 1, random.real(1.01, 2.5)}};
    const Vec3 origin = sphere.center + 10 * random.direction();
    const Ray ray(origin, sphere.center + 2.9f * random.direction() - origin);
    Intersection entry, exit, none;
    REQUIRE(sphere.intersect(ray, entry));
    REQUIRE(sphere.intersect(entry.getRefractedRay(), exit));
    CHECK_FALSE(exit.frontFacing);
    CHECK(exit.hitT > 1);
    const Ray leaving = exit.getRefractedRay();
    CHECK_FALSE(sphere.intersect(leaving, none));
    // By symmetry the way out mirrors the way in.
    CHECK(std::fabs(sine(leaving.dir, exit.normal) - sine(ray.dir, entry.normal)) <= 1e-4);
}
