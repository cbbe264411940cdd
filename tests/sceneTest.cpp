#include "swScene.h"

#include <algorithm>
#include <array>
#include <functional>

#include "support.h"
#include "swRayCount.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

const Ray downwards(Vec3(0, 0, 10), Vec3(0, 0, -1));

// Four primitives at z = -1 .. -4, pushed in the given order. Two are spheres.
Scene stack(const std::array<int, 4>& order) {
    const std::function<void(Scene&)> pushes[] = {
        [](Scene& s) { s.push(tile(-1, number(1))); },
        [](Scene& s) { s.push(Sphere(Vec3(0, 0, -2.25f), 0.25f, number(2))); },
        [](Scene& s) { s.push(std::make_shared<Plane>(-3.f, number(3))); },
        [](Scene& s) { s.push(std::make_shared<Sphere>(Vec3(0, 0, -5), 1.f, number(4))); }};
    Scene scene;
    for (const int i : order) pushes[i](scene);
    return scene;
}

}  // namespace

TEST_CASE("the nearest primitive is hit in whatever order they were pushed") {
    std::array<int, 4> order{0, 1, 2, 3};
    do {
        const Scene scene = stack(order);
        CAPTURE(order[0], order[1], order[2], order[3]);
        CHECK(hitBy(scene, downwards) == 1);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -2), 5.6f)) == 2);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 12.75f)) == 3);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 13.5f)) == 4);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, -9), Vec3(0, 0, 1))) == 4);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 11)) == -1);
        CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 11.5f)) == 1);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("a scene finds what a linear scan of its primitives finds") {
    Random random(GENERATE(range(0u, 40u)));
    std::vector<std::shared_ptr<Primitive>> all;
    Scene scene;
    for (int id = 0; id < random.whole(1, 80); ++id) {
        const Vec3 c = random.point(10);
        const Vec3 v[] = {c, c + random.point(4), c + random.point(4)};
        const Sphere sphere(c, random.real(0.1, 3), number(id));
        const Triangle triangle(v, number(id));
        const bool round = random.coin();
        if (round) all.push_back(std::make_shared<Sphere>(sphere));
        if (!round) all.push_back(std::make_shared<Triangle>(triangle));
        round ? scene.push(sphere) : scene.push(triangle);
    }
    for (int i = 0; i < 100; ++i) {
        const Ray ray(random.point(12), random.direction() * random.magnitude(0.1, 10),
                      random.real(0, 2), random.coin() ? FLT_MAX : random.real(2, 20));
        int expected = -1;
        float nearest = HUGE_VALF;
        for (const auto& primitive : all) {
            Intersection hit;
            if (!primitive->intersect(ray, hit) || !(hit.hitT < nearest)) continue;
            nearest = hit.hitT;
            expected = numberOf(hit);
        }
        CAPTURE(i, ray.orig, ray.dir, all.size());
        CHECK(hitBy(scene, ray) == expected);
        CHECK((hitBy(scene, ray, true) >= 0) == (expected >= 0));
    }
}

TEST_CASE("an any-hit query returns one of the hits inside the interval") {
    const Scene scene = stack({2, 0, 3, 1});
    CHECK(hitBy(scene, downwards, true) >= 1);
    const Ray between(Vec3(0, 0, 10), Vec3(0, 0, -1), 11.5f, 13.5f);
    const int found = hitBy(scene, between, true);
    CHECK((found == 2 || found == 3));
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 11), true) == -1);
}

TEST_CASE("of shapes hit at the same t the earlier type counts and then the one pushed first") {
    const int others = GENERATE(0, 1000);  // a few are scanned, many are in a tree
    const auto pushOthers = [&](Scene& scene) {
        for (int i = 0; i < others; ++i)
            scene.push(Sphere(Vec3(0.1f * static_cast<float>(i % 40), 3, -5), 0.5f, number(99)));
    };
    Scene scene;
    scene.push(std::make_shared<Plane>(1.f, number(1)));
    scene.push(tile(1, number(2)));
    scene.push(tile(1, number(3)));
    pushOthers(scene);
    CHECK(hitBy(scene, downwards) == 2);
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(4)));
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(5)));
    pushOthers(scene);
    CHECK(hitBy(scene, downwards) == 4);
}

TEST_CASE("both lecture spellings of intersect give the same result") {
    const Scene scene = stack({0, 1, 2, 3});
    Intersection byReference, byPointer;
    CHECK(scene.intersect(downwards, byReference));
    CHECK(scene.intersect(&downwards, byPointer));
    CHECK(byReference.hitT == byPointer.hitT);
    CHECK(numberOf(byReference) == numberOf(byPointer));
    const Ray upwards(Vec3(0, 0, 10), Vec3(0, 0, 1));
    CHECK_FALSE(scene.intersect(&upwards, byPointer, true));
    CHECK_FALSE(scene.intersect(upwards, byReference, true));
}

TEST_CASE("a miss leaves the hit record as it was") {
    const bool any = GENERATE(false, true);
    Scene scene = stack({3, 2, 1, 0});
    scene.push(std::make_shared<Claim>(NAN));
    Intersection hit;
    REQUIRE(scene.intersect(downwards, hit));
    const Intersection before = hit;
    CHECK_FALSE(scene.intersect(Ray(Vec3(0, 0, 10), Vec3(0, 0, 1)), hit, any));
    CHECK_FALSE(scene.intersect(Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 5), hit, any));
    CHECK(hit.hitT == before.hitT);
    CHECK(hit.frontFacing == before.frontFacing);
    CHECK(hit.positionError == before.positionError);
    CHECK(numberOf(hit) == numberOf(before));
    CHECK(distance(hit.position, before.position) == 0);
    CHECK(distance(hit.normal, before.normal) == 0);
    CHECK(distance(hit.ray.dir, before.ray.dir) == 0);
    CHECK(hit.ray.maxT == before.ray.maxT);
}

TEST_CASE("the record's ray is the caller's with its whole interval") {
    const bool any = GENERATE(false, true);
    const int nearest = GENERATE(0, 1, 2);
    // Each kind of primitive in turn is the nearest, so that the search has shortened its ray.
    Scene scene = stack({3, 2, 1, 0});
    if (nearest == 0) scene.push(tile(2, number(5)));
    if (nearest == 1) scene.push(Sphere(Vec3(0, 0, 1), 1, number(5)));
    if (nearest == 2) scene.push(std::make_shared<Plane>(2.f, number(5)));
    const Ray ray(Vec3(0, 0, 10), Vec3(0, 0, -2), 0.5f, 77, RayKind::refracted);
    Intersection hit;
    REQUIRE(scene.intersect(ray, hit, any));
    CHECK((any || numberOf(hit) == 5));
    CHECK(hit.ray.minT == 0.5f);
    CHECK(hit.ray.maxT == 77);
    CHECK(hit.ray.kind == RayKind::refracted);
    CHECK(distance(hit.ray.orig, ray.orig) == 0);
    CHECK(distance(hit.ray.dir, ray.dir) == 0);
}

TEST_CASE("the ray in the hit record may be traced again") {
    const bool any = GENERATE(false, true);
    Scene scene = stack({3, 2, 1, 0});
    scene.push(std::make_shared<Plane>(2.f, number(5)));
    Intersection hit;
    hit.ray = Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 77, RayKind::primary);
    takeRayCount();
    REQUIRE(scene.intersect(hit.ray, hit, any));
    CHECK((any || numberOf(hit) == 5));
    CHECK(hit.ray.maxT == 77);
    CHECK(takeRayCount()[RayKind::primary] == 1);
}

TEST_CASE("every query counts as one ray of its kind") {
    const Scene scene = stack({0, 1, 2, 3});
    Intersection hit;
    takeRayCount();
    for (const bool any : {false, true}) {
        scene.intersect(Ray(Vec3(0, 0, 9), Vec3(0, 0, 1), 0, 1, RayKind::primary), hit, any);
        scene.intersect(Ray(Vec3(0, 0, 9), Vec3(0, 0, -1), 0, 99, RayKind::primary), hit, any);
        scene.intersect(Ray(Vec3(0, 0, 9), Vec3(0, 0, -1), 0, 99, RayKind::shadow), hit, any);
    }
    const RayCount count = takeRayCount();
    CHECK(count[RayKind::primary] == 4);
    CHECK(count.hitsOf(RayKind::primary) == 2);
    CHECK(count[RayKind::shadow] == 2);
    CHECK(count.total() == 6);
    CHECK(takeRayCount().total() == 0);
}

TEST_CASE("a shadow ray ends at the light") {
    Random random(GENERATE(range(0u, 300u)));
    const float scale = random.magnitude(1e-6, 1e6);
    const Vec3 light = Vec3(random.real(-3, 3), random.real(-3, 3), random.real(1, 9)) * scale;
    const Vec3 floor[] = {Vec3(-9, -9, 0) * scale, Vec3(9, -9, 0) * scale, Vec3(0, 9, 0) * scale};
    Scene open;
    open.push(Triangle(floor, number(1)));
    Intersection hit, blocker;
    REQUIRE(open.intersect(
        Ray(Vec3(random.real(-1, 1), random.real(-1, 1), 1) * scale, Vec3(0, 0, -1)), hit));
    const Ray shadowRay = hit.getShadowRay(light);
    CAPTURE(scale, light, hit.position);
    CHECK_FALSE(open.intersect(shadowRay, blocker, true));

    // A sphere on the line to the light, so that its near side is at that fraction of the way.
    const auto sphereAt = [&](float fraction) {
        Scene scene = open;
        const Vec3 way = light - hit.position;
        const float radius = 0.02f * way.norm();
        scene.push(Sphere(hit.position + way * (fraction + 0.02f), radius, number(2)));
        return scene;
    };
    CHECK(sphereAt(0.5f).intersect(shadowRay, blocker, true));
    CHECK(sphereAt(0.999f).intersect(shadowRay, blocker, true));
    CHECK_FALSE(sphereAt(1.001f).intersect(shadowRay, blocker, true));
    CHECK_FALSE(sphereAt(1.5f).intersect(shadowRay, blocker, true));

    Scene lampInCeiling = open;
    lampInCeiling.push(std::make_shared<Plane>(light[2], number(3)));
    CHECK_FALSE(lampInCeiling.intersect(shadowRay, blocker, true));
}
