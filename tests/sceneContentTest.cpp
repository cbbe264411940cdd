#include <atomic>
#include <thread>

#include "support.h"
#include "swScene.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

const Ray downwards(Vec3(0, 0, 10), Vec3(0, 0, -1));

// Never hit, but leaves its marks all over the record.
class Scribbler : public Primitive {
public:
    bool intersect(const Ray&, Intersection& hit) const override {
        hit.position = hit.normal = Vec3(NAN, NAN, NAN);
        hit.hitT = hit.positionError = 1e-3f;
        hit.frontFacing = false;
        hit.material = number(98);
        hit.ray = Ray();
        return false;
    }
};

// Replaces some coordinates by numbers that are none.
Vec3 spoilt(Vec3 v, Random& random) {
    const float bad[] = {HUGE_VALF, -HUGE_VALF, NAN};
    v[random.whole(0, 2)] = bad[random.whole(0, 2)];
    if (random.coin()) v[random.whole(0, 2)] = bad[random.whole(0, 2)];
    return v;
}

// Primitives around the origin that can never be hit. Their number is 97.
void pushUnhittable(Scene& scene, Random& random) {
    const float badRadius[] = {HUGE_VALF, -HUGE_VALF, NAN, -0.0f, 0};
    scene.push(Sphere(Vec3(0, 0, 0), badRadius[random.whole(0, 4)], number(97)));
    scene.push(Sphere(spoilt(random.point(5), random), 3, number(97)));
    Vec3 v[] = {random.point(9), random.point(9), random.point(9)};
    const int bad = random.whole(0, 2);
    v[bad] = spoilt(v[bad], random);
    if (random.coin()) v[(bad + 1) % 3] = spoilt(v[(bad + 1) % 3], random);
    scene.push(Triangle(v, number(97)));
    const Vec3 flat[] = {v[bad == 0], v[bad == 0], random.point(9)};
    scene.push(Triangle(flat, number(97)));
}

}  // namespace

TEST_CASE("a primitive that overrides only intersect is hit") {
    Scene scene;
    scene.push(std::make_shared<Plane>(2.f, number(1)));
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(2)));
    Intersection hit;
    REQUIRE(scene.intersect(downwards, hit));
    CHECK(numberOf(hit) == 1);
    CHECK(hit.hitT == 8);
    CHECK(distance(hit.position, Vec3(0, 0, 2)) == 0);
    CHECK(distance(hit.normal, Vec3(0, 0, 1)) == 0);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 8.5f)) == 2);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 0, 8.5f), true) == 1);
}

TEST_CASE("a primitive that writes to the hit record on a miss changes nothing") {
    const bool first = GENERATE(true, false);
    Scene scene;
    if (first) scene.push(std::make_shared<Scribbler>());
    scene.push(std::make_shared<Plane>(2.f, number(1)));
    if (!first) scene.push(std::make_shared<Scribbler>());
    Intersection hit;
    REQUIRE(scene.intersect(downwards, hit));
    CHECK(numberOf(hit) == 1);
    CHECK(hit.hitT == 8);
    CHECK(hit.frontFacing);
    CHECK(hit.ray.maxT == FLT_MAX);
    CHECK(distance(hit.position, Vec3(0, 0, 2)) == 0);
    CHECK(hit.positionError < 0);  // the plane states none
}

TEST_CASE("the positionError of one primitive is never used for another") {
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(1)));
    scene.push(std::make_shared<Plane>(2.f, number(2)));
    Intersection hit;
    REQUIRE(scene.intersect(Ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 8.5f), hit));
    CHECK(hit.positionError >= 0);
    REQUIRE(scene.intersect(downwards, hit));
    CHECK(numberOf(hit) == 2);
    CHECK(hit.positionError < 0);
}

TEST_CASE("a reported hit outside the interval or at NaN does not count") {
    const float t = GENERATE(NAN, -NAN, HUGE_VALF, -HUGE_VALF, -1.f, 0.f, 1.f, 20.f, 21.f, FLT_MAX);
    const bool any = GENERATE(false, true);
    CAPTURE(t, any);
    const Ray ray(Vec3(0, 0, 10), Vec3(0, 0, -1), 1, 20);
    Scene scene;
    scene.push(std::make_shared<Claim>(t));
    CHECK(hitBy(scene, ray, any) == -1);
    scene.push(std::make_shared<Plane>(2.f, number(1)));
    CHECK(hitBy(scene, ray, any) == 1);
}

TEST_CASE("a null pointer is ignored") {
    Scene scene;
    scene.push(std::shared_ptr<Primitive>());
    CHECK(hitBy(scene, downwards) == -1);
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(1)));
    scene.push(std::shared_ptr<Primitive>(nullptr));
    CHECK(hitBy(scene, downwards) == 1);
    CHECK(hitBy(scene, downwards, true) == 1);
}

TEST_CASE("an empty scene has black background and no lights and no hits") {
    const Scene scene;
    CHECK(distance(scene.background(), Vec3(0, 0, 0)) == 0);
    CHECK(scene.lights().empty());
    CHECK(hitBy(scene, downwards) == -1);
    CHECK(hitBy(scene, downwards, true) == -1);
}

TEST_CASE("copies of a scene are independent") {
    Scene original;
    original.push(Sphere(Vec3(0, 0, 0), 1, number(1)));
    CHECK(hitBy(original, downwards) == 1);  // the query prepares it
    Scene copy = original;
    copy.push(Sphere(Vec3(0, 0, 3), 1, number(2)));
    copy.push(std::make_shared<Plane>(6.f, number(3)));
    copy.push(Light(Vec3(1, 2, 3)));
    copy.setBackground(Color(0, 1, 0));
    CHECK(hitBy(original, downwards) == 1);
    CHECK(original.lights().empty());
    CHECK(distance(original.background(), Vec3(0, 0, 0)) == 0);
    CHECK(hitBy(copy, downwards) == 3);
    CHECK(copy.lights().size() == 1);
    CHECK(distance(copy.background(), Vec3(0, 1, 0)) == 0);

    const Vec3 v[] = {Vec3(-9, -9, 8), Vec3(9, -9, 8), Vec3(0, 9, 8)};
    original.push(Triangle(v, number(4)));
    CHECK(hitBy(original, downwards) == 4);
    CHECK(hitBy(copy, downwards) == 3);
    original = copy;
    CHECK(hitBy(original, downwards) == 3);
}

TEST_CASE("a scene keeps its own copy of what is pushed by value") {
    Vec3 v[] = {Vec3(-9, -9, 8), Vec3(9, -9, 8), Vec3(0, 9, 8)};
    Sphere sphere(Vec3(0, 0, 0), 1, number(1));
    Triangle triangle(v, number(2));
    Scene scene;
    scene.push(sphere);
    scene.push(triangle);
    for (Vec3& corner : v) corner = Vec3(0, 0, 9);
    for (Vec3& corner : triangle.vertices) corner = Vec3(0, 0, 9);
    sphere.radius = 9.5f;
    CHECK(hitBy(scene, downwards) == 2);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 7), Vec3(0, 0, -1), 0, 5.5f)) == -1);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 7), Vec3(0, 0, -1), 0, 6.5f)) == 1);
}

TEST_CASE("non-finite primitives are never hit and hide nothing") {
    Random random(GENERATE(range(0u, 200u)));
    Scene scene;
    pushUnhittable(scene, random);
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(1)));
    pushUnhittable(scene, random);
    for (int i = 0; i < 20; ++i) {
        const Vec3 outwards = random.direction();
        CAPTURE(i, outwards);
        Intersection hit;
        REQUIRE(scene.intersect(Ray(outwards * 10, -outwards), hit));
        CHECK(numberOf(hit) == 1);
        CHECK(std::fabs(hit.hitT - 9) < 1e-5);
        CHECK(hitBy(scene, Ray(outwards * 10, -outwards), true) == 1);
        CHECK(hitBy(scene, Ray(outwards * 2, outwards), i % 2 == 0) == -1);
    }
}

TEST_CASE("a ray that is not finite or has no direction hits nothing") {
    Random random(GENERATE(range(0u, 300u)));
    const bool any = random.coin();
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 1, number(1)));
    const Vec3 v[] = {Vec3(-9, -9, 0), Vec3(9, -9, 0), Vec3(0, 9, 0)};
    scene.push(Triangle(v, number(2)));
    const Vec3 from = random.direction() * 10;
    CAPTURE(from, any);
    CHECK(hitBy(scene, Ray(from, spoilt(-from, random)), any) == -1);
    CHECK(hitBy(scene, Ray(spoilt(from, random), -from), any) == -1);
    CHECK(hitBy(scene, Ray(from, Vec3(0, 0, 0)), any) == -1);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 0), Vec3(0, 0, 0)), any) == -1);
    CHECK(hitBy(scene, Ray(from, -from, NAN), any) == -1);
    CHECK(hitBy(scene, Ray(from, -from, 0, NAN), any) == -1);
    CHECK(hitBy(scene, Ray(from, -from, 0, HUGE_VALF), any) >= 1);
}

TEST_CASE("many threads may send the first queries to a scene") {
    constexpr int count = 300, threads = 4;
    for (int round = 0; round < 30; ++round) {
        Scene scene;
        for (int i = 0; i < count; ++i)
            scene.push(Sphere(Vec3(static_cast<float>(3 * i), 0, 0), 1, number(i)));
        std::atomic<int> waiting{threads}, wrong{0};
        const auto ask = [&](int start) {
            --waiting;
            while (waiting > 0) std::this_thread::yield();
            for (int k = 0; k < count; ++k) {
                const int i = (start + 7 * k) % count;
                const Ray ray(Vec3(static_cast<float>(3 * i), 0, 9), Vec3(0, 0, -1));
                const Scene byValue = scene;  // as old lab programs pass it
                if (hitBy(k % 2 == 0 ? scene : byValue, ray, k % 3 == 0) != i) ++wrong;
            }
        };
        std::vector<std::thread> crowd;
        for (int i = 0; i < threads; ++i) crowd.emplace_back(ask, 50 * i);
        for (std::thread& thread : crowd) thread.join();
        CHECK(wrong == 0);
    }
}
