#include <algorithm>

#include "nff/nff.h"
#include "nff/polygon/polygons.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

// A statement p, or with normals pp.
std::string polygonText(const Polygon& corners, const std::vector<Vec3>& normals = {}) {
    std::string statement =
        (normals.empty() ? "p " : "pp ") + std::to_string(corners.size()) + "\n";
    for (std::size_t i = 0; i < corners.size(); ++i)
        statement += text(corners[i]) + (normals.empty() ? "" : text(normals[i])) + "\n";
    return statement;
}

Scene sceneOf(const std::string& statements) {
    const NffScene file = parse("l 0 0 99\n" + grey + statements);
    CHECK(file.warnings.empty());
    return file.scene;
}

// Both hit the same point in the same way, or both miss.
bool agree(const Scene& scene, const Primitive& shape, const Ray& ray) {
    Intersection a, b;
    const bool hit = scene.intersect(ray, a);
    if (hit != shape.intersect(ray, b)) return false;
    return !hit ||
           (a.hitT == b.hitT && a.frontFacing == b.frontFacing &&
            distance(a.normal, b.normal) == 0 && distance(a.material.color, b.material.color) == 0);
}

int disagreements(const Scene& scene, const Primitive& shape, Random& random) {
    int wrong = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 from = random.point(4);
        wrong += !agree(scene, shape, Ray(from, random.point(2) - from));
    }
    return wrong;
}

const Material greyMaterial(Color(0.5f, 0.5f, 0.5f));

// Whether a point lies in a polygon in the plane z = 0: a line from it crosses the outline an odd
// number of times.
bool isInside(const Polygon& polygon, const Vec3& p) {
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec3 a = toDouble(polygon[i]), b = toDouble(polygon[(i + 1) % polygon.size()]);
        const double y = p[1], x = p[0];
        if ((a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
            inside = !inside;
    }
    return inside;
}

bool hitFromAbove(const Scene& scene, const Vec3& p, Intersection& hit) {
    return scene.intersect(Ray(p + Vec3(0, 0, 1), Vec3(0, 0, -1)), hit);
}

Vec3 roundNormal(const Vec3& corner) {
    return (corner + Vec3(0, 0, 2)).normalize();
}

}  // namespace

TEST_CASE("a cone stands between its base and its apex") {
    Random random(GENERATE(range(0u, 60u)));
    const float sign = random.coin() ? 1.0f : -1.0f;
    const float base = sign * random.real(0, 2);
    const float apex = random.coin() ? base : sign * random.real(0, 1) * (random.coin() ? 1 : 0);
    if (base == 0 && apex == 0) return;
    const Cone cone(random.point(1), base, random.point(1), apex, greyMaterial);
    const std::string statement = "c " + text(cone.base) + text(cone.baseRadius) + "\n" +
                                  text(cone.apex) + text(cone.apexRadius);
    CAPTURE(statement);
    CHECK(disagreements(sceneOf(statement), cone, random) == 0);
}

TEST_CASE("a sphere may have a negative radius") {
    Random random(GENERATE(range(0u, 20u)));
    const Sphere sphere(random.point(1), random.real(-2, 2), greyMaterial);
    const std::string statement = "s " + text(sphere.center) + text(sphere.radius);
    CAPTURE(statement);
    CHECK(disagreements(sceneOf(statement), sphere, random) == 0);
    Intersection hit;
    const Vec3 outside = sphere.center + Vec3(0, 0, 5);
    REQUIRE(sceneOf(statement).intersect(Ray(outside, Vec3(0, 0, -1)), hit));
    CHECK((hit.hitT < 5) == (sphere.radius > 0));
    CHECK(hit.frontFacing);
}

TEST_CASE("a polygon of any shape is hit inside its outline alone") {
    const auto seed = GENERATE(range(0u, 100u));
    Random random(seed);
    const Polygon polygon = randomSimple(random, random.whole(4, 200));
    const Scene scene = sceneOf(polygonText(polygon));
    int wrong = 0;
    for (int i = 0; i < 300; ++i) {
        // Near a corner, where the outline matters.
        const Vec3 corner = polygon[static_cast<std::size_t>(
            random.whole(0, static_cast<int>(polygon.size()) - 1))];
        const Vec3 p = corner + Vec3(random.real(-1, 1), random.real(-1, 1), 0);
        Intersection hit;
        wrong += hitFromAbove(scene, p, hit) != isInside(polygon, p);
    }
    CAPTURE(seed, polygon.size());
    CHECK(wrong == 0);
}

TEST_CASE("a patch of three vertices has a normal at each of them") {
    Random random(GENERATE(range(0u, 60u)));
    const Polygon v = {random.point(2), random.point(2), random.point(2)};
    const Vec3 up = (v[1] - v[0]) % (v[2] - v[0]);
    std::vector<Vec3> n;
    for (int i = 0; i < 3; ++i) n.push_back(up + up.norm() * random.point(1.5));
    const auto isBelow = [&up](const Vec3& normal) { return normal * up < 0; };
    if (std::all_of(n.begin(), n.end(), isBelow)) return;
    const Patch patch(v.data(), n.data(), greyMaterial);
    CHECK(disagreements(sceneOf(polygonText(v, n)), patch, random) == 0);
}

TEST_CASE("every corner of a patch has its own normal, whatever its shape") {
    const auto seed = GENERATE(range(0u, 60u));
    CAPTURE(seed);
    Random random(seed);
    const Polygon polygon = star(random.whole(4, 60), [&](int) { return random.uniform(1, 2); });
    std::vector<Vec3> normals;
    for (const Vec3& corner : polygon) normals.push_back(3 * roundNormal(corner));
    const Scene scene = sceneOf(polygonText(polygon, normals));
    for (const Vec3& corner : polygon) {
        Intersection hit;
        REQUIRE(hitFromAbove(scene, 0.99f * corner, hit));  // the origin sees every corner
        CHECK(distance(hit.normal, roundNormal(corner)) < 0.15);
        CHECK(distance(hit.geometricNormal, Vec3(0, 0, 1)) == 0);
    }
}

TEST_CASE("a clockwise patch has its normals turned to the front") {
    const auto seed = GENERATE(range(0u, 30u));
    CAPTURE(seed);
    Random random(seed);
    Polygon polygon = star(random.whole(3, 60), [&](int) { return random.uniform(1, 2); });
    std::reverse(polygon.begin(), polygon.end());
    std::vector<Vec3> normals;
    for (const Vec3& corner : polygon) normals.push_back(roundNormal(corner));
    const Scene scene = sceneOf(polygonText(polygon, normals));
    for (const Vec3& corner : polygon) {
        Intersection hit;
        REQUIRE(hitFromAbove(scene, 0.99f * corner, hit));
        CHECK_FALSE(hit.frontFacing);
        CHECK(distance(hit.normal, roundNormal(corner)) < 0.15);
    }
}

TEST_CASE("shapes without area are read and never seen") {
    Random random(1);
    const std::string statement =
        GENERATE(as<std::string>(), "p 3  0 0 0  0 0 0  0 0 0", "p 3  0 0 0  1 1 0  2 2 0",
                 "p 4  0 0 0  1 1 0  2 2 0  3 3 0", "p 5  1 1 1  1 1 1  1 1 1  1 1 1  1 1 1",
                 "pp 3  0 0 0 0 0 1  0 0 0 0 0 1  0 0 0 0 0 1",
                 "pp 4  0 0 0 0 0 0  1 0 0 0 0 0  2 0 0 0 0 0  1 0 0 0 0 0");
    CAPTURE(statement);
    CHECK(disagreements(sceneOf(statement), Triangle(), random) == 0);
}

TEST_CASE("repeated vertices change nothing") {
    const auto seed = GENERATE(range(0u, 30u));
    CAPTURE(seed);
    Random random(seed);
    Polygon repeated, polygon = randomSimple(random, random.whole(4, 30));
    for (const Vec3& corner : polygon)
        repeated.insert(repeated.end(), static_cast<std::size_t>(random.whole(1, 3)), corner);
    const Scene once = sceneOf(polygonText(polygon)), often = sceneOf(polygonText(repeated));
    int wrong = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p(random.real(-2, 30), random.real(-3, 3), 0);
        Intersection a, b;
        wrong += hitFromAbove(once, p, a) != hitFromAbove(often, p, b);
    }
    CHECK(wrong == 0);
}

TEST_CASE("a polygon may have 10000 vertices") {
    const auto radius = [](int i) { return i % 2 == 0 ? 1.0 : 2.0; };
    CHECK(countOf(sceneOf(polygonText(star(10000, radius))), "triangles") == 9998);
}

TEST_CASE("nothing carries over from one polygon to the next") {
    const Scene scene = sceneOf(polygonText(star(40, [](int) { return 2.0; })) +
                                "pp 4 9 0 0 1 0 9  11 0 0 1 0 9  11 2 0 1 0 9  9 2 0 1 0 9\n" +
                                "p 3 19 0 0  21 0 0  20 2 0\n" +
                                "pp 3 29 0 0 -1 0 9  31 0 0 -1 0 9  30 2 0 -1 0 9\n");
    const auto slant = [&scene](float x) {
        Intersection hit;
        REQUIRE(hitFromAbove(scene, Vec3(x, 0.5f, 0), hit));
        return hit.normal[0];
    };
    CHECK((slant(0) == 0 && slant(10) > 0 && slant(20) == 0 && slant(30) < 0));
    CHECK(countOf(scene, "triangles") == 39);
    CHECK(countOf(scene, "patches") == 3);
}
