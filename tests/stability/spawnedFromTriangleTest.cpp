// A ray that leaves a triangle never meets it again, on whichever side. The exact oracle asks for
// the height of the spawned ray's start over the triangle's plane, and where the exact segment from
// there to the light crosses it. Where the light is within shadowMargin of the plane, or the
// crossing that close to an edge, the answer may be either.

#include "stability/spawn.h"
#include "stability/triangleCases.h"

using namespace sw;
using namespace test;
using exact::Real;
using exact::Real3;

namespace {

TriangleCase randomDeparture(Random& random) {
    const float size = random.magnitude(1e-3, 1e3);
    const Vec3 at = random.direction() * (random.coin() ? size * random.magnitude(0.1, 1e4) : 0);
    Vec3 v[] = {at + random.point(size), at + random.point(size), at + random.point(size)};
    double a = random.uniform(0, 1), b = random.uniform(0, 1 - a);
    if (random.whole(0, 9) == 0) a = 0;
    const Vec3 target =
        num::toFloat((1 - a - b) * toDouble(v[0]) + a * toDouble(v[1]) + b * toDouble(v[2]));
    const Vec3 grazing = (v[1] - target).normalize();
    const Vec3 away =
        random.whole(0, 3) == 0 ? moved(grazing, random.direction(), 1e-3) : anyDirection(random);
    const double distance = size * random.magnitude(0.1, 1e4);
    Ray ray = rayThrough(random, moved(target, away, distance), target);
    const float scale = anyScale(random);
    for (Vec3& vertex : v) vertex *= scale;
    ray.orig *= scale;
    return {Triangle(v, anyGlass(random)), ray};
}

// The triangle's plane as the hit saw it: from the side that the ray came from.
struct Plane {
    Real3 v0, normal;
    double extent;

    Plane(const Triangle& triangle, const Intersection& hit) : v0(triangle.vertices[0]) {
        const Real3 e1 = Real3(triangle.vertices[1]) - v0, e2 = Real3(triangle.vertices[2]) - v0;
        normal = (hit.frontFacing ? 1 : -1) * exact::unit(cross(e1, e2));
        extent = 2 * static_cast<double>(exact::length(e1) + exact::length(e2));
    }
    Real height(const Real3& p) const { return dot(normal, p - v0); }
};

std::string judgeSpawned(const TriangleCase& c, const Intersection& hit, const Ray& ray,
                         bool above) {
    const Plane plane(c.triangle, hit);
    Intersection next;
    if ((plane.height(ray.orig) > 0) != above) return "starts on the wrong side";
    if (!startsNear(ray, hit, plane.extent)) return "starts too far off";
    if (c.triangle.intersect(ray, next)) return describe("hits again at", next.hitT);
    return "";
}

// How far inside the triangle a point of its plane lies.
Real depthInside(const Triangle& triangle, const Real3& normal, bool front, const Real3& p) {
    Real depth = 0;
    for (int i = 0; i < 3; ++i) {
        const Real3 a(triangle.vertices[i]), edge = Real3(triangle.vertices[(i + 1) % 3]) - a;
        const Real fromEdge = dot(normal, cross(edge, p - a)) / exact::length(edge);
        const Real inwards = front ? fromEdge : -fromEdge;
        depth = i == 0 ? inwards : exact::min(depth, inwards);
    }
    return depth;
}

// -1: the exact segment is free, 1: the triangle blocks it, 0: too close to call.
int blocked(const Triangle& triangle, const Intersection& hit, const Vec3& light) {
    const Plane plane(triangle, hit);
    const Real3 from(hit.getShadowRay(light).orig), to(light);
    const Real margin = shadowMargin(hit, light, plane.extent), height = plane.height(to);
    if (height > margin) return -1;
    if (height > -margin) return 0;
    const Real above = plane.height(from), part = above / (above - height);
    const Real3 crossing = from + part * (to - from);
    const bool inside = depthInside(triangle, plane.normal, hit.frontFacing, crossing) > margin;
    return inside && part < 1 - 0x1p-20 ? 1 : 0;
}

}  // namespace

TEST_CASE("a ray that leaves a triangle never hits it again") {
    int hits = 0;
    checkRandomCases(2 * familySize, [&](Random& random) {
        const TriangleCase c = randomDeparture(random);
        Intersection hit;
        if (!c.triangle.intersect(c.ray, hit)) return std::string();
        ++hits;
        const Ray refracted = hit.getRefractedRay();
        std::string problem = judgeSpawned(c, hit, hit.getReflectedRay(), true);
        if (!problem.empty()) return "reflected: " + problem + describe(c.ray, c.triangle);
        problem = judgeSpawned(c, hit, refracted, isTotal(refracted, hit));
        if (problem.empty()) return problem;
        return "refracted: " + problem +
               describe(c.ray, c.triangle, c.triangle.material.refractiveIndex);
    });
    CHECK(hits > familySize);
}

TEST_CASE("a triangle blocks the light behind it and no other") {
    int count[3] = {0, 0, 0};
    checkRandomCases(2 * familySize, [&](Random& random) {
        const TriangleCase c = randomDeparture(random);
        Intersection hit, blocker;
        if (!c.triangle.intersect(c.ray, hit)) return std::string();
        const Vec3* v = c.triangle.vertices;
        const double size = (v[1] - v[0]).norm();
        const Vec3 light =
            moved(hit.position, random.direction(), size * random.magnitude(0.1, 100));
        const int expected = blocked(c.triangle, hit, light);
        ++count[expected + 1];
        const bool found = c.triangle.intersect(hit.getShadowRay(light), blocker);
        if (expected == 0 || found == (expected > 0)) return std::string();
        return describe(found ? "blocked" : "not blocked", c.ray, c.triangle, "light", light);
    });
    CHECK(count[0] > familySize / 4);
    CHECK(count[2] > familySize / 4);
}

// A light on a wall is not behind it. Rounding moves t by u, and by another u through the direction
// to the light, however flat the ray, as rounding is by coordinate and the wall parallel to two
// axes: together less than the 4u = 2^-22 by which the ray stops short.
TEST_CASE("a wall that bears the light does not block it") {
    checkRandomCases(familySize, [](Random& random) {
        const float size = random.magnitude(1e-3, 1e3) * anyScale(random);
        const int axis = random.whole(0, 2);
        const float height = size * random.real(-10, 10);
        Vec3 v[] = {random.point(1), random.point(1), random.point(1)};
        for (Vec3& vertex : v) {
            vertex *= size;
            vertex[axis] = height;
        }
        const Vec3 light = num::toFloat((toDouble(v[0]) + toDouble(v[1]) + toDouble(v[2])) / 3.0);
        const Triangle wall(v, Material());
        Intersection hit, blocker;
        hit.position = random.point(10) * size;
        hit.normal = random.direction();
        hit.positionError = num::surfaceError(hit.position, size);
        const Ray shadow = hit.getShadowRay(light);
        return wall.intersect(shadow, blocker) ? describe(shadow, wall, "light", light) : "";
    });
}
