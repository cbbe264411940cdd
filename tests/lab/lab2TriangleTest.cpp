#include <cmath>
#include <functional>

#include "lab/triangles.h"

using namespace lab;
using namespace sw;

namespace {

// Clear of all edges.
constexpr Barycentric inside[] = {
    {0.25f, 0.25f}, {0.5f, 0.25f}, {0.125f, 0.75f}, {0.75f, 0.125f}, {0.125f, 0.125f}};

std::string asked(const TriangleCase& sample, const Ray& ray) {
    return lab::text(ray) + " to " + lab::text(sample.shape);
}

bool isNear(const Vec3& a, const Vec3& b, float most) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= most)) return false;  // or NaN
    return true;
}

// Something asked of a hit that should be.
struct Question {
    const TriangleCase& sample;
    const Ray& ray;
    const Barycentric& place;
    bool fromFront;
    const Intersection& hit;
};

// Rays at a right angle and slanted, from both sides. A miss fails the test.
void eachHit(const std::function<void(const Question&)>& check) {
    for (const TriangleCase& sample : triangleCases())
        for (const Barycentric& place : inside)
            for (const float height : {2.f, -2.f, 0.75f, -0.75f})
                for (const float slant : {0.f, 1.f, -0.5f}) {
                    const Vec3 away =
                        sample.size * (height * sample.normal + slant * sample.across);
                    const Ray ray = rayTo(sample.shape, place, away);
                    Intersection hit;
                    if (!sample.shape.intersect(ray, hit))
                        fail({asked(sample, ray), "no hit",
                              "a hit at t = 1, where " + lab::text(place), whyMissed()});
                    check({sample, ray, place, height > 0, hit});
                }
}

}  // namespace

TEST_CASE("a ray through the inside of a triangle hits it", "[lab2]") {
    eachHit([](const Question&) {});
}

TEST_CASE("t counts in units of the ray's direction", "[lab2]") {
    requireHits();
    const Triangle plain = plainTriangle();
    for (const float length : {1.f, 2.f, 0.5f, 8.f}) {
        const Ray ray({1, 1, 4}, {0, 0, -length});
        Intersection hit;
        hit.hitT = -1;
        const bool found = plain.intersect(ray, hit);
        if (found && std::fabs(hit.hitT - 4 / length) <= 1e-4f) continue;
        const bool distance = std::fabs(hit.hitT - 4) <= 1e-4f;
        fail({lab::text(ray) + " to " + lab::text(plain),
              found ? "a hit at t = " + lab::text(hit.hitT) : "no hit",
              "a hit at t = " + lab::text(4 / length),
              !found     ? whyMissed()
              : distance ? "this t is a distance: t says how often the direction, as long as it "
                           "is, has to be added to the origin"
                         : "orig + t dir has to lie in the plane of the triangle, and hitT is that "
                           "t"});
    }
}

TEST_CASE("a hit says where it is", "[lab2]") {
    eachHit([](const Question& q) {
        const Vec3 expected = at(q.sample.shape, q.place);
        if (!isNear(q.hit.position, expected, 1e-4f * q.sample.size))
            fail({asked(q.sample, q.ray), "the position " + lab::text(q.hit.position),
                  lab::text(expected),
                  q.hit.position.isZero() ? "the record's position is not set"
                                          : "the position is the point of the ray that belongs "
                                            "to t, not a direction and not relative to a vertex"});
        if (!(std::fabs(q.hit.hitT - 1) <= 1e-3f))
            fail({asked(q.sample, q.ray), "hitT " + lab::text(q.hit.hitT), "1",
                  "the record's hitT is what the scene compares to find the nearest hit: is it set "
                  "to t?"});
    });
}

TEST_CASE("the normal of a hit has length 1", "[lab2]") {
    eachHit([](const Question& q) {
        const float length = q.hit.normal.norm();
        if (std::fabs(length - 1) <= 1e-4f) return;
        fail({asked(q.sample, q.ray),
              "the normal " + lab::text(q.hit.normal) + ", of length " + lab::text(length),
              "length 1",
              length > 0
                  ? "a cross product is as long as its parallelogram is large: shading needs "
                    "the direction alone"
                  : "the record's normal is not set"});
    });
}

TEST_CASE("the normal of a hit is on the side that the ray came from", "[lab2]") {
    eachHit([](const Question& q) {
        const Vec3 expected = q.fromFront ? q.sample.normal : -q.sample.normal;
        Vec3 n = q.hit.normal;
        n.normalize();
        if (isNear(n, expected, 1e-3f)) return;
        fail({asked(q.sample, q.ray), "the normal " + lab::text(q.hit.normal),
              "the direction " + lab::text(expected),
              isNear(n, -expected, 1e-3f)
                  ? "both n and -n stand on the plane: the record wants the one that looks back to "
                    "where the ray came from"
                  : "the normal is at right angles to both sides that leave a vertex: which "
                    "product of two vectors is that?"});
    });
}

TEST_CASE("the front is where the vertices run counter-clockwise", "[lab2]") {
    eachHit([](const Question& q) {
        if (q.hit.frontFacing == q.fromFront) return;
        fail({asked(q.sample, q.ray) + (q.fromFront ? ", from the front" : ", from behind"),
              q.hit.frontFacing ? "frontFacing is true" : "frontFacing is false",
              q.fromFront ? "true" : "false",
              "the cross product of the sides looks out of the front, before it is turned to the "
              "ray: does the ray run against it?"});
    });
}

TEST_CASE("a hit carries the triangle's material", "[lab2]") {
    eachHit([](const Question& q) {
        const Material &got = q.hit.material, &expected = q.sample.shape.material;
        if ((got.color - expected.color).isZero() && got.reflectivity == expected.reflectivity &&
            got.transparency == expected.transparency &&
            got.refractiveIndex == expected.refractiveIndex)
            return;
        fail({asked(q.sample, q.ray), "a material of colour " + lab::text(got.color),
              "the triangle's, of colour " + lab::text(expected.color),
              "whoever shades the hit knows the record alone: the material has to be in it"});
    });
}

TEST_CASE("a hit carries the ray", "[lab2]") {
    eachHit([](const Question& q) {
        if ((q.hit.ray.orig - q.ray.orig).isZero() && (q.hit.ray.dir - q.ray.dir).isZero()) return;
        fail({asked(q.sample, q.ray), "the record holds " + lab::text(q.hit.ray), "the same ray",
              "reflection and refraction start from the record's ray: it has to be in it"});
    });
}
