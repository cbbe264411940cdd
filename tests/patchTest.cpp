#include "swPatch.h"

#include <algorithm>

#include "stability/meshes.h"
#include "support.h"
#include "swSphere.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

const Material glass({0.1f, 0.2f, 0.3f}, 0.4f, 0.5f, 1.6f);

// A patch of any size, not too thin, and a ray from either side to a point of it.
struct Case {
    Vec3 vertices[3];
    Ray ray;

    explicit Case(Random& random, double scale = 1) {
        do
            for (Vec3& v : vertices) v = random.point(10);
        while (!(glm::length(cross(edge(1), edge(2))) > 20));
        const double v = random.uniform(0, 1), w = random.uniform(0, 1 - v);
        const dvec3 target = toDouble(vertices[0]) + v * edge(1) + w * edge(2);
        const dvec3 from = toDouble(random.point(30));
        ray = Ray(num::toFloat(scale * from), num::toFloat(scale * (target - from)));
        for (Vec3& vertex : vertices) vertex = num::toFloat(scale * toDouble(vertex));
    }

    dvec3 edge(int i) const { return toDouble(vertices[i]) - toDouble(vertices[0]); }
    Triangle triangle() const { return Triangle(vertices, glass); }
    Vec3 ownNormal() const { return num::toFloat(glm::normalize(cross(edge(1), edge(2)))); }
};

// Near n, within some 45 degrees, and of any length.
Vec3 bentFrom(Random& random, const Vec3& n) {
    return (n + random.direction() * random.real(0, 0.7)).normalize() * random.magnitude(1e-6, 1e6);
}

Patch flat(const Vec3* vertices, const Vec3& normal) {
    const Vec3 normals[] = {normal, normal, normal};
    return Patch(vertices, normals, glass);
}

bool isSameRay(const Ray& a, const Ray& b) {
    return isSame(a.orig, b.orig) && isSame(a.dir, b.dir) && a.maxT == b.maxT;
}

bool sameSpawnedRays(const Intersection& a, const Intersection& b) {
    const Vec3 light(1, 20, 3);
    return isSameRay(a.getShadowRay(light), b.getShadowRay(light)) &&
           isSameRay(a.getReflectedRay(), b.getReflectedRay()) &&
           isSameRay(a.getRefractedRay(), b.getRefractedRay());
}

double cosine(const Vec3& a, const Vec3& b) {
    return dot(toDouble(a), toDouble(b));
}

Scene roundBall(int level, const Vec3& center, float radius, const Material& material) {
    const Mesh mesh = icosphere(level);
    Scene scene;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        Vec3 vertices[3], normals[3];
        for (int k = 0; k < 3; ++k) {
            normals[k] = mesh.corner(i, k);
            vertices[k] = center + radius * normals[k];
        }
        scene.push(std::make_shared<Patch>(vertices, normals, material));
    }
    return scene;
}

}  // namespace

TEST_CASE("a patch with the normals of its plane is a triangle") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Case c(random);
    Intersection expected, hit;
    REQUIRE(c.triangle().intersect(c.ray, expected));
    const Vec3 outward = expected.frontFacing ? expected.normal : -expected.normal;
    Patch patch = flat(c.vertices, outward);
    patch.material.refractiveIndex = 1.7f;
    REQUIRE(patch.intersect(c.ray, hit));
    CHECK(isSame(hit.normal, expected.normal));
    CHECK(isSame(hit.position, expected.position));
    CHECK(hit.hitT == expected.hitT);
    CHECK(hit.frontFacing == expected.frontFacing);
    CHECK(hit.positionError == expected.positionError);
    CHECK(hit.material.refractiveIndex == 1.7f);
    hit.material = glass;
    CHECK(sameSpawnedRays(hit, expected));
    const Bounds box = patch.bounds(), other = c.triangle().bounds();
    CHECK((isSame(box.min, other.min) && isSame(box.max, other.max)));
}

TEST_CASE("the normal is interpolated between the vertices") {
    const auto seed = GENERATE(range(0u, 500u));
    Random random(seed);
    const double scale = random.magnitude(1e-8, 1e8);
    CAPTURE(seed, scale);
    const Case c(random, scale);
    Vec3 normals[3];
    for (Vec3& n : normals) n = bentFrom(random, c.ownNormal());
    Intersection hit;
    if (!Patch(c.vertices, normals, glass).intersect(c.ray, hit)) return;  // aimed at an edge

    // The areas of the parts opposite to each vertex.
    const dvec3 p = toDouble(hit.position), n = glm::normalize(cross(c.edge(1), c.edge(2)));
    dvec3 expected(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
        const dvec3 a = toDouble(c.vertices[(i + 1) % 3]), b = toDouble(c.vertices[(i + 2) % 3]);
        expected += dot(cross(a - p, b - p), n) * glm::normalize(toDouble(normals[i]));
    }
    expected = glm::normalize(hit.frontFacing ? expected : -expected);
    const bool facesRay = dot(expected, glm::normalize(toDouble(c.ray.dir))) < 0;
    CHECK(distance(hit.normal, facesRay ? expected : toDouble(hit.geometricNormal)) <= 1e-4);
    CHECK(distance(hit.geometricNormal, hit.frontFacing ? n : -n) <= 1e-6);
    CHECK(std::fabs(glm::length(toDouble(hit.normal)) - 1) <= 1e-6);
}

TEST_CASE("at a vertex a patch has exactly the vertex's normal") {
    const Vec3 vertices[] = {{1, 2, 3}, {5, 2, 3}, {2, 9, 3}};
    const Vec3 normals[] = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, -0.28f, 0.96f}};
    const Patch patch(vertices, normals, glass);
    for (int i = 0; i < 3; ++i) {
        Intersection hit;
        REQUIRE(patch.intersect(Ray(vertices[i] + Vec3(0, 0, 4), {0, 0, -1}), hit));
        CHECK(isSame(hit.normal, normals[i]));
        REQUIRE(patch.intersect(Ray(vertices[i] - Vec3(0, 0, 4), {0, 0, 1}), hit));
        CHECK(isSame(hit.normal, -normals[i]));
        CHECK_FALSE(hit.frontFacing);
    }
}

TEST_CASE("a ball of patches has the normals of the sphere") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    static const Scene ball = roundBall(4, {3, -4, 5}, 2, glass);  // faces of some 4 degrees
    Random random(seed);
    const Vec3 from = Vec3(3, -4, 5) + 9 * random.direction();
    const Vec3 to = Vec3(3, -4, 5) + random.direction() * random.real(0, 1.8);
    Intersection hit;
    REQUIRE(ball.intersect(Ray(from, to - from), hit));
    const dvec3 outward = glm::normalize(toDouble(hit.position) - dvec3(3, -4, 5));
    // Within a face the plane's normal is off by up to 0.04, the interpolated one by its square.
    CHECK(distance(hit.normal, outward) <= 0.04 * 0.04);
    CHECK(cosine(hit.geometricNormal, hit.normal) >= 0.99);
}

// Wild normals and rays that graze the patch, from both sides.
TEST_CASE("whatever the normals, rays stay on their side of a patch") {
    const auto seed = GENERATE(range(0u, 3000u));
    CAPTURE(seed);
    Random random(seed);
    Case c(random);
    if (random.coin()) c.ray = Ray(c.ray.orig + 0.99f * c.ray.dir, c.ray.dir);
    const Vec3 normals[] = {random.direction(), random.direction(), random.direction()};
    const Material material({1, 1, 1}, 0.5f, 0.5f, random.magnitude(0.4, 2.5));
    const Patch patch(c.vertices, normals, material);
    Intersection hit, again;
    if (!patch.intersect(c.ray, hit)) return;
    const Vec3 up = hit.geometricNormal;
    CHECK(cosine(hit.normal, c.ray.dir) < 0);
    CHECK(cosine(hit.normal, up) > 0);

    const Ray reflected = hit.getReflectedRay(), refracted = hit.getRefractedRay();
    CHECK(cosine(reflected.dir, up) > 0);
    CHECK_FALSE(patch.intersect(reflected, again));
    CHECK_FALSE(patch.intersect(refracted, again));
    const double below = cosine(refracted.orig - hit.position, up);
    CHECK(below * cosine(refracted.dir, up) > 0);
    CHECK(std::fabs(glm::length(toDouble(refracted.dir)) - 1) <= 1e-6);
    CHECK(std::fabs(glm::length(toDouble(reflected.dir)) - 1) <= 1e-6);
    CHECK(cosine(hit.getShadowRay(random.point(50)).orig - hit.position, up) > 0);
}

TEST_CASE("light from below a patch is blocked by the patch itself") {
    const Vec3 vertices[] = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
    const Patch patch = flat(vertices, Vec3(4, 0, 3));
    Intersection hit, blocker;
    REQUIRE(patch.intersect(Ray({0, 0, 5}, {0, 0, -1}), hit));
    const Vec3 below(5, 0, -1), above(5, 0, 1);
    CHECK(hit.normal * (below - hit.position) > 0);
    CHECK(patch.intersect(hit.getShadowRay(below), blocker));
    CHECK_FALSE(patch.intersect(hit.getShadowRay(above), blocker));
}

TEST_CASE("a closed ball of patches keeps its light inside") {
    const auto seed = GENERATE(range(0u, 2000u));
    CAPTURE(seed);
    static const Scene ball = roundBall(1, {0, 0, 0}, 1, glass);
    Random random(seed);
    const Vec3 from = 5 * random.direction(), to = random.direction() * random.real(0, 0.95);
    const Vec3 light = random.direction() * random.real(0, 0.7);
    Intersection hit, blocker;
    if (!ball.intersect(Ray(from, to - from), hit)) return;
    CHECK(hit.frontFacing);
    CHECK(ball.intersect(hit.getShadowRay(light), blocker, true));
    REQUIRE(ball.intersect(Ray(light, to - light), hit));
    CHECK_FALSE(hit.frontFacing);
    CHECK_FALSE(ball.intersect(hit.getShadowRay(light), blocker, true));
    CHECK(ball.intersect(hit.getReflectedRay(), blocker));
    CHECK(ball.intersect(hit.getShadowRay(from), blocker, true));
}

TEST_CASE("the plane's normal replaces a vertex normal without direction") {
    const Vec3 bad = GENERATE(Vec3(0, 0, 0), Vec3(NAN, 0, 1), Vec3(0, 1, HUGE_VALF),
                              Vec3(-HUGE_VALF, HUGE_VALF, NAN));
    const Vec3 vertices[] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Ray ray({1, 1, 5}, {0, 0, -1});
    Intersection hit;
    REQUIRE(flat(vertices, bad).intersect(ray, hit));
    CHECK(isSame(hit.normal, Vec3(0, 0, 1)));
    const Vec3 one[] = {bad, {0.6e30f, 0, 0.8e30f}, {0, 0, 1e-30f}};
    REQUIRE(Patch(vertices, one, glass).intersect(Ray({2, 0, 5}, {0, 0, -1}), hit));
    CHECK(distance(hit.normal, Vec3(0.6f, 0, 1.8f).normalize()) <= 1e-6);
    const Vec3 opposite[] = {{1, 0, 1}, {-1, 0, -1}, {-1, 0, -1}};  // half-way they cancel out
    REQUIRE(Patch(vertices, opposite, glass).intersect(Ray({2, 0, 5}, {0, 0, -1}), hit));
    CHECK(isSame(hit.normal, Vec3(0, 0, 1)));
}

TEST_CASE("a patch without area is never hit") {
    const Vec3 vertices[] = {{0, 0, 0}, {2, 2, 0}, {1, 1, 0}};
    Intersection hit;
    CHECK_FALSE(flat(vertices, Vec3(0, 0, 1)).intersect(Ray({1, 1, 5}, {0, 0, -1}), hit));
    CHECK_FALSE(flat(vertices, Vec3()).intersect(Ray({1, 1, 5}, {0, 0, -1}), hit));
}

TEST_CASE("a student's primitive that sets only the normal spawns rays along it") {
    const Plane plane(2, glass);
    Intersection hit;
    REQUIRE(plane.intersect(Ray({0, 0, 5}, {1, 0, -1}), hit));
    Intersection stated = hit;
    stated.geometricNormal = hit.normal;
    CHECK(sameSpawnedRays(hit, stated));
    CHECK(hit.getReflectedRay().orig[2] > 2);
    CHECK(hit.getRefractedRay().orig[2] < 2);
}
