// lab::traceRay() to depth 1000, the most that the command line allows: no overflow of the stack,
// no NaN, no negative channel. A path splits where a surface both mirrors and refracts, so the deep
// scenes do one or the other; scenes with both are traced to depth 6.

#include <thread>

#include "stability/randomScenes.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

Material pureMaterial(Random& random, bool opaque) {
    const Color color(random.real(0, 1), random.real(0, 1), random.real(0, 1));
    const float weight = random.coin() ? 1.0f : random.real(0.9, 1);
    if (opaque || random.coin()) return Material(color, weight);
    return Material(color, 0, weight, random.real(0.4, 2.5));
}

// A mirror all around glass, mirrors and triangles: a path that never ends by itself.
Scene hall(Random& random) {
    Scene scene;
    scene.push(Sphere({0, 0, 0}, 30, pureMaterial(random, true)));
    for (int i = random.whole(0, 3); i > 0; --i) {
        Sphere sphere = anySphere(random);
        Triangle triangle = anyTriangle(random);
        sphere.material = pureMaterial(random, false);
        triangle.material = pureMaterial(random, false);
        scene.push(sphere);
        scene.push(triangle);
    }
    scene.push(Light(random.point(10), {1, 0.5f, 0.25f}));
    scene.setBackground({0.1f, 0.2f, 0.3f});
    return scene;
}

// Nested balls of glass, so that rays are refracted, totally reflected and caught.
Scene glass(Random& random) {
    Scene scene;
    for (int i = random.whole(1, 5); i > 0; --i)
        scene.push(Sphere(random.point(1), random.real(1, 12),
                          Material({1, 1, 1}, 0, 1, random.real(0.4, 2.5))));
    scene.push(Light(random.point(20)));
    scene.setBackground({1, 1, 1});
    return scene;
}

Scene splitting(Random& random) {
    Scene scene;
    for (int i = random.whole(1, 8); i > 0; --i) {
        scene.push(anySphere(random));
        scene.push(anyTriangle(random));
    }
    scene.push(Light(random.point(10)));
    return scene;
}

std::string judge(const Color& color, const Ray& ray) {
    for (const float channel : color.m)
        if (!(channel >= 0 && channel < 1e6f)) return describe("colour", color, ray);
    return "";
}

template <typename MakeScene>
void checkColors(int depth, MakeScene makeScene) {
    checkRandomCases(familySize, [&](Random& random) {
        const Scene scene = makeScene(random);
        const Ray ray(random.point(10), random.direction());
        return judge(lab::traceRay(ray, scene, random.whole(0, 3) == 0 ? depth : depth / 20), ray);
    });
}

}  // namespace

TEST_CASE("a hall of mirrors can be traced to depth 1000") {
    checkColors(1000, hall);
}

TEST_CASE("glass can be traced to depth 1000") {
    checkColors(1000, glass);
}

TEST_CASE("paths that split stay finite and positive") {
    checkColors(6, splitting);
}

TEST_CASE("depth 1000 fits the stack of a thread") {
    Color color(-1, -1, -1);
    std::thread([&] {
        Scene scene;
        scene.push(Sphere({0, 0, 0}, 1, Material({1, 1, 1}, 1)));
        color = lab::traceRay(Ray({0.5f, 0, 0}, {0.6f, 0.8f, 0}), scene, 1000);
    }).join();
    CHECK(distance(color, Vec3(0, 0, 0)) == 0);
}
