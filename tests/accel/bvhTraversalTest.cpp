// Which leaves a ray reaches.
#include <algorithm>
#include <vector>

#include "accel/bvhSupport.h"
#include "swSphere.h"
#include "swTriangle.h"

using namespace sw;
using namespace test;

namespace {

constexpr float inf = Bounds::infinity;

// Small triangles and spheres, all over a cube or on a sphere's surface.
struct Shapes {
    std::vector<Sphere> spheres;
    std::vector<Triangle> triangles;  // numbered after the spheres

    Shapes(Random& random, int n, float scale) {
        for (int i = 0; i < n; ++i) {
            const Vec3 p = random.coin() ? random.point(10) : random.direction() * 10;
            const Vec3 v[] = {p * scale, (p + random.point(2)) * scale,
                              (p + random.point(2)) * scale};
            if (random.coin())
                spheres.push_back(Sphere(v[0], scale * random.magnitude(1e-2, 2), Material()));
            else
                triangles.push_back(Triangle(v, Material()));
        }
    }
    std::vector<Bounds> boxes() const {
        std::vector<Bounds> all;
        for (const auto& s : spheres) all.push_back(s.bounds());
        for (const auto& t : triangles) all.push_back(t.bounds());
        return all;
    }
    // Shortens the ray to the hit, if there is one.
    bool hit(std::size_t i, Ray& ray) const {
        Intersection hit;
        const std::size_t n = spheres.size();
        if (!(i < n ? spheres[i].intersect(ray, hit) : triangles[i - n].intersect(ray, hit)))
            return false;
        ray.maxT = hit.hitT;
        return true;
    }
};

// Where the ray ends: at the nearest hit, or at its maxT.
float bruteForce(const Shapes& shapes, std::size_t n, Ray ray) {
    for (std::size_t i = 0; i < n; ++i) shapes.hit(i, ray);
    return ray.maxT;
}

float throughTree(const Shapes& shapes, const Bvh& bvh, Ray ray, bool any) {
    const auto leaf = [&](std::uint32_t first, std::uint32_t count, float& limit) {
        bool found = false;
        for (const auto i : bvh.order().subspan(first, count)) found |= shapes.hit(i, ray);
        limit = widened(ray.maxT);
        return any && found;
    };
    bvh.traverse(ray, leaf);
    return ray.maxT;
}

}  // namespace

TEST_CASE("no box that a ray meets is missed by rounding") {
    const auto seed = GENERATE(range(0u, 280u));
    Random random(seed);
    const auto kind = static_cast<Kind>(seed % static_cast<unsigned>(Kind::kinds));
    const float scale = seed % 5 == 0   ? 1e29f
                        : seed % 5 == 1 ? 1.0f
                                        : std::ldexp(1.0f, random.whole(-30, 30));
    const auto boxes = kind == Kind::hugeBesideTiny && scale > 1e15f
                           ? randomBoxes(random, kind, random.whole(1, 200), 1)
                           : randomBoxes(random, kind, random.whole(1, 200), scale);
    const Bvh bvh(boxes, random.whole(1, 8));
    int missed = 0, twice = 0, met = 0;
    for (int k = 0; k < 200; ++k) {
        const auto i =
            static_cast<std::size_t>(random.whole(0, static_cast<int>(boxes.size()) - 1));
        const Ray ray = randomRay(random, boxes[i], scale);
        const auto times = reached(bvh, ray);
        for (std::size_t j = 0; j < boxes.size(); ++j) {
            if (meets(ray, boxes[j])) ++met, missed += times[j] == 0;
            twice += times[j] > (ray.minT < 0 ? 2 : 1);
        }
    }
    CAPTURE(seed, scale, met);
    CHECK(missed == 0);
    CHECK(twice == 0);  // for each side of the origin
}

TEST_CASE("the tree finds exactly the linear scan's hits") {
    const auto seed = GENERATE(range(0u, 60u));
    Random random(seed);
    const float scale = std::ldexp(1.0f, random.whole(-30, 30));
    const Shapes shapes(random, seed < 20 ? random.whole(0, 20) : random.whole(0, 3000), scale);
    const auto boxes = shapes.boxes();
    const Bvh bvh(boxes, random.whole(1, 8));
    int different = 0;
    for (int k = 0; k < 200; ++k) {
        Ray ray(random.point(12) * scale, random.direction() * random.magnitude(1e-3, 1e3));
        if (random.coin()) ray.maxT = 10 * scale / ray.dir.norm();
        if (random.whole(0, 3) == 0) ray.minT = -ray.maxT;
        const float expected = bruteForce(shapes, boxes.size(), ray);
        different += throughTree(shapes, bvh, ray, false) != expected;
        different += (throughTree(shapes, bvh, ray, true) < ray.maxT) != (expected < ray.maxT);
    }
    CAPTURE(seed, scale, boxes.size());
    CHECK(different == 0);
}

TEST_CASE("leaves are reached in the order of their distance") {
    std::vector<Bounds> boxes;
    for (int i = 0; i < 1000; ++i) {
        const float x = static_cast<float>(i * 7919 % 1000);
        boxes.push_back({{x, 0, 0}, {x + 0.5f, 1, 1}});
    }
    const Bvh bvh(boxes, 1);
    for (const float sign : {1.0f, -1.0f}) {
        float last = -inf;
        int outOfOrder = 0;
        bvh.traverse(Ray({500 - 600 * sign, 0.5f, 0.5f}, {sign, 0, 0}),
                     [&](std::uint32_t first, std::uint32_t, float&) {
                         const float along = sign * boxes[bvh.order()[first]].min[0];
                         outOfOrder += along < last;
                         last = along;
                         return false;
                     });
        CHECK(outOfOrder == 0);
    }
}

TEST_CASE("rays that are not finite or have an empty interval visit nothing") {
    const auto boxes = terrain(10);
    const Bvh bvh(boxes);
    for (const float bad : {inf, -inf, NAN})
        for (int i = 0; i < 3; ++i) {
            Ray ray({0.5f, 0.5f, 3}, {0, 0, -1});
            ray.orig[i] = bad;
            CHECK(costOfMiss(bvh, ray).nodes == 0);
            ray = Ray({0.5f, 0.5f, 3}, {0, 0, -1});
            ray.dir[i] = bad;
            CHECK(costOfMiss(bvh, ray).nodes == 0);
        }
    CHECK(costOfMiss(bvh, Ray({0.5f, 0.5f, 3}, {0, 0, -1}, 1, 1)).nodes == 0);
    CHECK(costOfMiss(bvh, Ray({0.5f, 0.5f, 3}, {0, 0, -1}, 0, NAN)).nodes == 0);
    CHECK(costOfMiss(bvh, Ray({0.5f, 0.5f, 3}, {0, 0, -1}, NAN, 1)).nodes == 0);
}

TEST_CASE("a direction whose reciprocal overflows still finds its hits") {
    const std::vector<Bounds> boxes = {{{1e-6f, -1, 0}, {2e-6f, 1, 3}}};
    const Bvh bvh(boxes);
    for (const float minT : {0.0f, -1.0f}) {
        const Ray ray({0, 0, 0}, {1e-40f, 0, 1e-34f}, minT);
        REQUIRE(meets(ray, boxes[0]));
        CHECK(costOfMiss(bvh, ray).primitives == 1);
    }
}
