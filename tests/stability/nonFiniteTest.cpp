// Non-finite rays and geometry are never hit, and a scene that holds some answers as without them.

#include <limits>

#include "stability/randomScenes.h"

using namespace sw;
using namespace test;

namespace {

float notFinite(Random& random) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const int kind = random.whole(0, 2);
    return kind == 0 ? infinity : kind == 1 ? -infinity : std::numeric_limits<float>::quiet_NaN();
}

// Spoils one coordinate or several.
void spoil(Random& random, Vec3& v) {
    const int axis = random.whole(0, 2);
    for (int i = 0; i < 3; ++i)
        if (i == axis || random.whole(0, 3) == 0) v[i] = notFinite(random);
}

void spoil(Random& random, Ray& ray) {
    const int kind = random.whole(0, 7);
    if (kind == 0) ray.minT = std::numeric_limits<float>::quiet_NaN();
    if (kind == 1) ray.maxT = std::numeric_limits<float>::quiet_NaN();
    if (kind == 2) ray.dir = Vec3(0, 0, -0.0f);
    if (kind >= 3 && kind != 4) spoil(random, ray.orig);
    if (kind >= 3 && kind != 3) spoil(random, ray.dir);
}

Sphere spoiltSphere(Random& random) {
    Sphere sphere = anySphere(random);
    const int kind = random.whole(0, 3);
    if (kind == 0) sphere.radius = notFinite(random);
    if (kind == 1) sphere.radius = random.coin() ? 0.0f : -0.0f;
    if (kind >= 2) spoil(random, sphere.center);
    if (kind == 3 && random.coin()) sphere.radius = notFinite(random);
    return sphere;
}

Triangle spoiltTriangle(Random& random) {
    Triangle triangle = anyTriangle(random);
    const int corner = random.whole(0, 2);
    for (int i = 0; i < 3; ++i)
        if (i == corner || random.whole(0, 3) == 0) spoil(random, triangle.vertices[i]);
    return triangle;
}

Ray anyRay(Random& random) {
    return {random.point(20), anyDirection(random) * random.magnitude(1e-3, 1e3)};
}

}  // namespace

TEST_CASE("a spoilt ray hits nothing") {
    checkRandomCases(2 * familySize, [](Random& random) {
        Ray ray = anyRay(random);
        spoil(random, ray);
        const Sphere sphere = anySphere(random), around(ray.orig, 100, Material());
        const Triangle triangle = anyTriangle(random);
        Scene scene;
        scene.push(sphere);
        scene.push(around);
        scene.push(triangle);
        Intersection hit;
        if (sphere.intersect(ray, hit)) return describe(ray, sphere);
        if (around.intersect(ray, hit)) return describe(ray, around);
        if (triangle.intersect(ray, hit)) return describe(ray, triangle);
        if (scene.intersect(ray, hit, random.coin())) return describe("scene:", ray);
        return std::string();
    });
}

TEST_CASE("a spoilt shape is never hit") {
    checkRandomCases(2 * familySize, [](Random& random) {
        const Ray ray = anyRay(random);
        const Sphere sphere = spoiltSphere(random);
        const Triangle triangle = spoiltTriangle(random);
        Scene scene;
        scene.push(sphere);
        scene.push(triangle);
        Intersection hit;
        if (sphere.intersect(ray, hit)) return describe(ray, sphere);
        if (triangle.intersect(ray, hit)) return describe(ray, triangle);
        if (scene.intersect(ray, hit, random.coin())) return describe("scene:", ray);
        return std::string();
    });
}

TEST_CASE("spoilt shapes and rays do not change what others hit") {
    checkRandomCases(200, [](Random& random) {
        Scene sound, mixed;
        for (int i = random.whole(1, 200); i > 0; --i) {
            Shapes list;
            const std::shared_ptr<Primitive> shape =
                random.coin() ? std::shared_ptr<Primitive>(new Sphere(anySphere(random)))
                              : std::shared_ptr<Primitive>(new Triangle(anyTriangle(random)));
            add(sound, list, shape);
            add(mixed, list, shape);
            if (random.coin()) mixed.push(spoiltSphere(random));
            if (random.coin()) mixed.push(spoiltTriangle(random));
            if (random.whole(0, 9) == 0)
                mixed.push(std::make_shared<BoundlessSphere>(spoiltSphere(random).center, 0.0f,
                                                             Material()));
        }
        for (int i = 0; i < 100; ++i) {
            Ray ray = anyRay(random), bad = ray;
            spoil(random, bad);
            Intersection expected, hit;
            if (mixed.intersect(bad, hit)) return describe("hit by", bad);
            const bool any = random.coin();
            const bool found = sound.intersect(ray, expected, any);
            if (mixed.intersect(ray, hit, any) != found) return describe("not", found, ray);
            if (found && !any && hit.hitT != expected.hitT)
                return describe("t", hit.hitT, "not", expected.hitT, ray);
        }
        return std::string();
    });
}
