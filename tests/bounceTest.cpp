#include "support.h"
#include "swRayCount.h"
#include "testScenes.h"
#include "tools/common/mainFunctions.h"

// How often rays are reflected and refracted, and where they then go.

using namespace sw;
using namespace test;

namespace {

Color traced(const Ray& ray, const Scene& scene, int depth, RayCount& count) {
    takeRayCount();
    const Color color = lab::traceRay(ray, scene, depth);
    count = takeRayCount();
    return color;
}

// Glass between z = 0 and z = thickness; its faces look outwards.
Scene slab(float thickness, const Material& glass) {
    Scene scene;
    scene.push(tile(thickness, glass));
    Triangle bottom = tile(0, glass);
    std::swap(bottom.vertices[1], bottom.vertices[2]);
    scene.push(bottom);
    return scene;
}

}  // namespace

TEST_CASE("between two half mirrors every bounce adds half as much") {
    const int depth = GENERATE(range(0, 6));
    const Material halfMirror(Color(1, 1, 1), 0.5f);
    Scene scene;
    scene.push(tile(0, halfMirror));
    scene.push(tile(2, halfMirror));
    scene.push(Light(Vec3(0, 0, 1)));
    RayCount count;
    // The surfaces met add 1/2, 1/4, 1/8 ...
    const Color color = traced(Ray(Vec3(0, 0, 0.5f), Vec3(0, 0, -1)), scene, depth, count);
    CAPTURE(depth);
    CHECK(distance(color, dvec3(1 - std::ldexp(1, -(depth + 1)))) < 1e-6);
    CHECK(count[RayKind::reflected] == static_cast<unsigned>(depth));
    CHECK(count[RayKind::shadow] == static_cast<unsigned>(depth + 1));
    CHECK(count.total() == static_cast<unsigned>(2 * depth + 2));
}

TEST_CASE("a ray leaves a corridor of mirrors when it was reflected often enough") {
    const int depth = GENERATE(range(0, 8));
    constexpr int needed = 5;
    const Material mirror(Color(1, 1, 1), 1);
    Scene scene;
    scene.setBackground(Color(0.5f, 1, 0.25f));
    // Climbs at 45 degrees between x = -1 and x = 1, which both end at height 11.
    for (const float x : {-1.f, 1.f}) {
        const Vec3 wall[] = {Vec3(x, -99, -1), Vec3(x, 99, -1), Vec3(x, 0, 11)};
        scene.push(Triangle(wall, mirror));
    }
    RayCount count;
    const Color color = traced(Ray(Vec3(0, 0, 1), Vec3(1, 0, 1)), scene, depth, count);
    CAPTURE(depth);
    CHECK(distance(color, depth < needed ? Vec3(0, 0, 0) : scene.background()) < 1e-6);
    CHECK(count[RayKind::reflected] == static_cast<unsigned>(std::min(depth, needed)));
    CHECK(count[RayKind::shadow] == 0);
}

TEST_CASE("a ray passes as many panes as its depth allows") {
    const int depth = GENERATE(range(0, 6)), panes = GENERATE(0, 1, 2, 3, 4);
    Scene scene;
    scene.setBackground(Color(0.25f, 0.5f, 1));
    for (int i = 0; i < panes; ++i)
        scene.push(tile(static_cast<float>(i), Material(Color(1, 1, 1), 0, 1, 1)));
    RayCount count;
    const Color color = traced(Ray(Vec3(0, 0, 9), Vec3(0.1f, 0, -1)), scene, depth, count);
    CAPTURE(depth, panes);
    CHECK(distance(color, depth < panes ? Vec3(0, 0, 0) : scene.background()) < 1e-6);
    CHECK(count[RayKind::refracted] == static_cast<unsigned>(std::min(depth, panes)));
}

TEST_CASE("a glass slab shows the background undistorted") {
    Random random(GENERATE(range(0u, 300u)));
    const float thickness = random.real(0.1, 2), index = random.real(1.05, 2.5);
    Scene scene = slab(thickness, Material(Color(1, 1, 1), 0, 1, index));
    const auto rays = std::make_shared<Recorder>();
    scene.push(rays);
    scene.setBackground(Color(0.1f, 0.7f, 0.4f));

    Vec3 d = random.direction();
    d[2] = random.coin() ? 0.3f + std::fabs(d[2]) : -0.3f - std::fabs(d[2]);
    d.normalize();
    const Ray ray(Vec3(0, 0, d[2] > 0 ? -1.f : thickness + 1), d);
    RayCount count;
    CAPTURE(thickness, index, d);
    CHECK(distance(lab::traceRay(ray, scene, 1), Vec3(0, 0, 0)) == 0);  // still inside
    rays->rays.clear();
    CHECK(distance(traced(ray, scene, 2, count), scene.background()) < 1e-6);
    CHECK(count[RayKind::refracted] == 2);
    CHECK(count.total() == 3);

    // It leaves in its old direction, moved sideways by s sin(a) (1 - cos(a) / (n cos(b))), where
    // sin(a) = n sin(b): Hecht, Optics, section 4.4.
    const Ray& leaving = rays->rays.back();
    CHECK(distance(leaving.dir, d) < 64 * u);
    const double cosA = std::fabs(toDouble(d).z), sinA = std::sqrt(1 - cosA * cosA);
    const double nCosB = std::sqrt(double(index) * double(index) - sinA * sinA);
    const dvec3 moved = glm::cross(toDouble(leaving.orig) - toDouble(ray.orig), toDouble(d));
    const double expected = double(thickness) * sinA * (1 - cosA / nCosB);
    CHECK(std::fabs(glm::length(moved) - expected) < 0.005);
}

TEST_CASE("light that is totally reflected inside a slab does not leave it") {
    Scene scene = slab(1, Material(Color(1, 1, 1), 0, 1, 1.5f));
    const auto rays = std::make_shared<Recorder>();
    scene.push(rays);
    const int depth = GENERATE(range(0, 6));
    // From inside, at 45 degrees: beyond the critical angle of 41.8.
    lab::traceRay(Ray(Vec3(-6, 0, 0.5f), Vec3(1, 0, 1)), scene, depth);
    REQUIRE(rays->rays.size() == static_cast<unsigned>(depth + 1));
    for (int i = 0; i <= depth; ++i) {
        const Ray& ray = rays->rays[static_cast<unsigned>(i)];
        CAPTURE(i);
        CHECK(distance(Vec3(ray.dir).normalize(),
                       dvec3(1, 0, i % 2 == 0 ? 1 : -1) / std::sqrt(2.0)) < 4e-7);
        CHECK((ray.orig[2] > -1e-3f && ray.orig[2] < 1.001f));
    }
}
