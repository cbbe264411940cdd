// Rays whose weight is 0 are not traced, and shapes that a ray cannot hit are not tested. None of
// that may change the picture: here it is compared, bit for bit, with one that leaves out nothing.

#include <cstring>
#include <memory>
#include <vector>

#include "student.h"
#include "swRayCount.h"
#include "testScenes.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

// Asks every primitive.
struct PlainScene {
    std::vector<std::shared_ptr<Primitive>> primitives;
    std::vector<Light> allLights;

    bool intersect(Ray ray, Intersection& nearest, bool = false) const {
        bool found = false;
        for (const auto& primitive : primitives) {
            Intersection hit;
            if (!primitive->intersect(ray, hit)) continue;
            nearest = hit;
            ray.maxT = hit.hitT;
            found = true;
        }
        return found;
    }
    const std::vector<Light>& lights() const { return allLights; }
    Color background() const { return {}; }
};

// Follows every ray, and multiplies with zeros.
const Student leavesOutNothing{.testsWeight = false};

// Shadow rays that can change the colour of what a ray hits.
std::uint64_t shadowRaysNeeded(const Ray& ray, const PlainScene& scene) {
    Intersection hit;
    if (!scene.intersect(ray, hit)) return 0;
    std::uint64_t needed = 0;
    for (const Light& light : scene.lights()) {
        const float cosine = hit.normal * (light.position - hit.position).normalize();
        needed += cosine > 0 && 1 - hit.material.reflectivity - hit.material.transparency > 0 &&
                  !hit.material.color.times(light.color).isZero();
    }
    return needed;
}

Material anyMaterial(Random& random) {
    const Color color = random.whole(0, 3) == 0
                            ? Color(0, 0, 0)
                            : Color(random.real(0, 1), random.real(0, 1), random.real(0, 1));
    const Material all[] = {Material(color), Material(color, 0.25f), Material(color, 1),
                            Material(color, 0.25f, 0.75f, 1.5f), Material(color, 0, 0.5f, 1.3f)};
    return all[random.whole(0, 4)];
}

Vec3 onGrid(const Vec3& v) {
    return {std::round(v[0] * 8) / 8, std::round(v[1] * 8) / 8, std::round(v[2] * 8) / 8};
}

// The same primitives and lights for both.
void fill(Random& random, int count, Scene& scene, PlainScene& plain) {
    const auto push = [&](const auto& shape) {
        scene.push(shape);
        plain.primitives.push_back(std::make_shared<std::decay_t<decltype(shape)>>(shape));
    };
    for (int i = 0; i < count; ++i) {
        // Exact sums, so that two triangles make a parallelogram.
        const Vec3 c = onGrid(random.point(10));
        const Vec3 a = onGrid(random.direction() * 3), b = onGrid(random.direction() * 3);
        const Vec3 v[] = {c, c + a, c + b}, opposite[] = {c + a + b, c + b, c + a};
        const int kind = random.whole(0, 3);
        const Material material = anyMaterial(random);
        if (kind == 0) push(Sphere(c, random.real(0.5, 2), material));
        if (kind == 1) push(Cone(c, 1, c + a, random.real(0, 2), material));
        if (kind >= 2) push(Triangle(v, material));
        if (kind == 3) push(Triangle(opposite, material));
    }
    for (int i = random.whole(0, 3); i > 0; --i) {
        plain.allLights.emplace_back(random.point(20), Color(1, random.real(0, 1), 0));
        scene.push(plain.allLights.back());
    }
}

}  // namespace

TEST_CASE("leaving out rays changes no bit of the picture") {
    Random random(GENERATE(range(0u, 30u)));
    Scene scene;
    PlainScene plain;
    fill(random, random.whole(1, 120), scene, plain);
    for (int i = 0; i < 60; ++i) {
        const Ray ray(random.direction() * 25, random.direction());
        const Ray inwards(ray.orig, (random.point(10) - ray.orig).normalize());
        const Color expected = leavesOutNothing(inwards, plain, 3),
                    found = lab::traceRay(inwards, scene, 3);
        CAPTURE(i, plain.primitives.size(), expected, found);
        CHECK(std::memcmp(&expected, &found, sizeof found) == 0);
    }
}

TEST_CASE("only rays that can change the picture are traced") {
    Random random(GENERATE(range(0u, 20u)));
    Scene scene;
    PlainScene plain;
    fill(random, random.whole(1, 60), scene, plain);
    for (int i = 0; i < 40; ++i) {
        const Vec3 origin = random.direction() * 25;
        const Ray ray(origin, (random.point(10) - origin).normalize());
        takeRayCount();
        lab::traceRay(ray, scene, 0);
        const RayCount flat = takeRayCount();
        CHECK(flat[RayKind::shadow] == shadowRaysNeeded(ray, plain));
        CHECK(flat[RayKind::reflected] + flat[RayKind::refracted] == 0);
        Intersection hit;
        const bool found = plain.intersect(ray, hit);
        takeRayCount();
        lab::traceRay(ray, scene, 1);
        const RayCount deep = takeRayCount();
        CHECK(deep[RayKind::reflected] == (found && hit.material.reflectivity > 0));
        CHECK(deep[RayKind::refracted] == (found && hit.material.transparency > 0));
    }
}

TEST_CASE("a scene reports its contents and whether it needed a tree") {
    Scene scene;
    CHECK(countOf(scene, "spheres") == 0);
    CHECK_FALSE(scene.parts().tree);
    for (int i = 0; i < 20; ++i) {
        scene.push(tile(static_cast<float>(i), number(i)));
        scene.push(Sphere(Vec3(0, 0, 0), 1, number(i)));
    }
    scene.push(Cone());
    scene.push(Patch());
    scene.push(std::make_shared<Plane>(0.f, number(1)));
    CHECK(countOf(scene, "triangles") == 20);
    CHECK(countOf(scene, "spheres") == 20);
    CHECK(countOf(scene, "cones") + countOf(scene, "patches") + countOf(scene, "other") == 3);
    CHECK_FALSE(scene.parts().tree);
    for (int i = 0; i < 1000; ++i) scene.push(tile(static_cast<float>(i), number(i)));
    CHECK(countOf(scene, "triangles") == 1020);
    CHECK(scene.parts().tree);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 2000), Vec3(0, 0, -1))) == 999);
    scene.push(tile(1500, number(7)));
    CHECK(countOf(scene, "triangles") == 1021);
    CHECK(hitBy(scene, Ray(Vec3(0, 0, 2000), Vec3(0, 0, -1))) == 7);
}
