// Scene::intersect against the loop over all primitives that defines it. Whatever speeds a scene up
// must keep every decision of the primitives' own intersect(), so hitT is equal to the last bit.

#include <algorithm>
#include <cmath>

#include "stability/randomScenes.h"
#include "stability/sphereCases.h"
#include "stability/triangleCases.h"

using namespace sw;
using namespace test;

namespace {

struct Mixture {
    Scene scene;
    Shapes shapes;
};

// The last triangle in integers, so that sums are exact, or its other half.
std::shared_ptr<Primitive> anyHalf(Random& random, const Shapes& others) {
    if (!others.empty())
        if (const auto* last = dynamic_cast<const Triangle*>(others.back().get()))
            return std::make_shared<Triangle>(otherHalf(*last));
    Vec3 v[3];
    for (Vec3& corner : v)
        for (float& x : corner.m) x = static_cast<float>(random.whole(-10, 10));
    return std::make_shared<Triangle>(v, Material());
}

std::shared_ptr<Primitive> anyShape(Random& random, const Shapes& others) {
    switch (random.whole(0, 16)) {
        case 0:  // a duplicate
            if (!others.empty())
                return others[static_cast<std::size_t>(
                    random.whole(0, static_cast<int>(others.size()) - 1))];
            [[fallthrough]];
        case 1:  // one of many around the same centre
            return std::make_shared<Sphere>(Vec3(1, 2, 3), random.magnitude(1e-3, 30), Material());
        case 2:  // tiny
            return std::make_shared<Sphere>(random.point(10), 1e-6f, Material());
        case 3:  // huge
            return random.whole(0, 9) == 0
                       ? std::make_shared<Sphere>(random.point(1e6), 1e6f, Material())
                       : std::make_shared<Sphere>(random.point(1e5), 1e4f, Material());
        case 4:
            return std::make_shared<BoundlessSphere>(random.point(10), 0.1f, Material());
        case 5:
        case 6:
        case 7:
            return std::make_shared<Sphere>(anySphere(random));
        case 8:  // seen from inside
            return std::make_shared<Sphere>(random.point(10), -random.magnitude(0.1, 30),
                                            Material());
        case 9:
            return std::make_shared<Cone>(random.point(10), random.real(0, 3), random.point(10),
                                          random.real(0, 3), Material());
        case 10: {
            const Vec3 normals[] = {random.direction(), random.direction(), random.direction()};
            return std::make_shared<Patch>(anyTriangle(random).vertices, normals, Material());
        }
        case 11:
        case 12:
        case 13:
            return anyHalf(random, others);
        default:
            return std::make_shared<Triangle>(anyTriangle(random));
    }
}

Mixture anyMixture(Random& random, int size) {
    Mixture m;
    int boundless = 0;
    while (static_cast<int>(m.shapes.size()) < size) {
        const auto shape = anyShape(random, m.shapes);
        if (dynamic_cast<BoundlessSphere*>(shape.get()) != nullptr && ++boundless > 20) continue;
        add(m.scene, m.shapes, shape);
    }
    return m;
}

Ray anyRay(Random& random, const Shapes& shapes) {
    const auto& aim =
        shapes[static_cast<std::size_t>(random.whole(0, static_cast<int>(shapes.size()) - 1))];
    const Vec3 from = random.point(random.magnitude(1, 1000));
    Ray ray(from, anyDirection(random));
    if (const auto* s = dynamic_cast<const Sphere*>(aim.get()))
        ray = rayThrough(random, from, moved(s->center, random.direction(), s->radius));
    if (const auto* t = dynamic_cast<const Triangle*>(aim.get()))
        ray = rayThrough(random, from, t->vertices[random.whole(0, 2)]);
    if (random.whole(0, 3) == 0) ray.dir = anyDirection(random);
    if (random.coin()) ray.maxT = random.magnitude(1, 1e4);
    if (random.coin()) ray.minT = random.magnitude(1e-3, 10);
    return ray;
}

// What is wrong with the scene's answer, if anything.
std::string judge(const Mixture& m, const Ray& ray) {
    float nearest = INFINITY;
    std::vector<float> all;
    for (const auto& shape : m.shapes) {
        Intersection hit;
        if (!shape->intersect(ray, hit)) continue;
        all.push_back(hit.hitT);
        nearest = std::fmin(nearest, hit.hitT);
    }
    Intersection closest, some;
    const bool found = m.scene.intersect(ray, closest);
    const bool foundAny = m.scene.intersect(ray, some, true);
    if (found == all.empty()) return describe("closest: found", found, "not", nearest, ray);
    if (foundAny == all.empty()) return describe("any: found", foundAny, "not", nearest, ray);
    if (m.scene.isOccluded(ray) != foundAny) return describe("occluded: not", foundAny, ray);
    if (!found) return "";
    if (closest.hitT != nearest) return describe("t", closest.hitT, "not", nearest, ray);
    if (std::find(all.begin(), all.end(), some.hitT) == all.end())
        return describe("any: nothing is hit at", some.hitT, ray);
    if (closest.ray.maxT != ray.maxT) return describe("another ray in the record", ray);
    return "";
}

}  // namespace

TEST_CASE("a scene finds exactly what the linear scan finds") {
    int violations = 0;
    std::string first;
    for (unsigned seed = 0; seed < 100; ++seed) {
        Random random(seed);
        const int size = seed == 0 ? 5000 : static_cast<int>(random.magnitude(1, 1000));
        const Mixture mixture = anyMixture(random, size);
        for (int i = 0; i < familySize / 80; ++i) {
            const std::string problem = judge(mixture, anyRay(random, mixture.shapes));
            if (!problem.empty() && violations++ == 0)
                first = describe("seed", seed, "size", size, "ray", i, problem.c_str());
        }
    }
    INFO("first of " << violations << ": " << first);
    CHECK(violations == 0);
}

TEST_CASE("a scene finds an extreme sphere exactly where the sphere is hit") {
    checkRandomCases(4 * familySize, [](Random& random) {
        const SphereCase c = randomSphereCase(random);
        Mixture m;
        for (int i = random.whole(1, 3); i > 0; --i)
            add(m.scene, m.shapes, std::make_shared<Sphere>(c.sphere));
        const std::string problem = judge(m, c.ray);
        return problem.empty() ? problem : problem + describe(c.sphere);
    });
}

TEST_CASE("a scene finds an extreme triangle exactly where the triangle is hit") {
    checkRandomCases(4 * familySize, [](Random& random) {
        const TriangleCase c = randomTriangleCase(random);
        Mixture m;
        for (int i = random.whole(1, 3); i > 0; --i) {
            add(m.scene, m.shapes, std::make_shared<Triangle>(c.triangle));
            add(m.scene, m.shapes, std::make_shared<Triangle>(otherHalf(c.triangle)));
        }
        const std::string problem = judge(m, c.ray);
        return problem.empty() ? problem : problem + describe(c.triangle);
    });
}
