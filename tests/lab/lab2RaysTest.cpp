#include <cfloat>
#include <cmath>

#include "lab/photo.h"
#include "lab/triangles.h"

using namespace lab;
using namespace sw;

namespace {

constexpr const char* notANumber =
    "n * dir is 0 and so is what it divides: 0 / 0 is NaN, and NaN answers every comparison with "
    "false. Which answer lets it through?";
constexpr const char* infinite =
    "n * dir is 0: a number divided by it is infinite, and no point of the ray";

// No ray has any business with that triangle.
void expectMiss(const std::string& about, const Triangle& t, const Ray& ray, const char* hint) {
    Intersection hit;
    hit.hitT = 0;
    if (!t.intersect(ray, hit)) return;
    const bool nan = std::isnan(hit.hitT) || std::isnan(hit.position[0]);
    fail({lab::text(ray) + ", " + about + " " + lab::text(t),
          "a hit at t = " + lab::text(hit.hitT) + ", position " + lab::text(hit.position), "no hit",
          nan ? notANumber : hint});
}

// The plain triangle is met at t = 4 between minT and maxT.
bool metWithin(float minT, float maxT) {
    return isHit(plainTriangle(), Ray({1, 1, 2}, {0, 0, -0.5f}, minT, maxT));
}

void expectWithin(float minT, float maxT, bool met, const char* hint) {
    if (metWithin(minT, maxT) == met) return;
    fail({"a ray that meets " + lab::text(plainTriangle()) +
              " at t = 4, with minT = " + lab::text(minT) + " and maxT = " + lab::text(maxT),
          met ? "no hit" : "a hit", met ? "a hit" : "no hit", met ? whyMissed() : hint});
}

constexpr const char* past =
    "a hit counts only before maxT: shadow rays end at the light, and nearer things hide others";
constexpr const char* early =
    "a hit counts only after minT: what leaves a surface must not meet it again";

}  // namespace

// Whole numbers, so that floats lose nothing.
TEST_CASE("a ray in the plane of a triangle is no hit", "[lab2]") {
    requireHits();
    for (const TriangleCase& sample :
         {triangleCases()[0], triangleCases()[1], triangleCases()[2], triangleCases()[3]})
        for (const Barycentric& from : {Barycentric{-1, 0}, Barycentric{2, 0}, Barycentric{0, -1},
                                        Barycentric{0, 0}, Barycentric{3, 5}})
            for (const Barycentric& to :
                 {Barycentric{0, 1}, Barycentric{1, 0}, Barycentric{1, 1}, Barycentric{-2, 3}}) {
                const Triangle& t = sample.shape;
                const Vec3 along = at(t, to) - at(t, {0, 0});
                expectMiss("in the plane of", t, Ray(at(t, from), along), infinite);
            }
}

TEST_CASE("a ray parallel to a triangle is no hit", "[lab2]") {
    requireHits();
    const Triangle t = plainTriangle();
    for (const float height : {4.f, -4.f, 0.25f})
        for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(-2, 1, 0)})
            for (const Vec3& start : {Vec3(1, 1, 0), Vec3(-4, 0, 0), Vec3(4, 4, 0)})
                expectMiss("parallel to", t, Ray(start + Vec3(0, 0, height), along), infinite);
}

TEST_CASE("a triangle without area is never hit", "[lab2]") {
    requireHits();
    const Vec3 a(1, 0, 0), middle(2, 1, 1), b(3, 2, 2), origin(2, 1, 6);
    const char* hint = "a triangle whose corners lie on a line has no normal: n is 0 there";
    for (const Triangle& t : {triangle(a, a, a), triangle(a, a, b), triangle(a, b, a),
                              triangle(b, a, a), triangle(a, b, middle), triangle(a, middle, b)})
        for (const Vec3& target : {a, middle, b})
            expectMiss("without area:", t, Ray(origin, target - origin), hint);
}

TEST_CASE("a triangle behind the ray's origin is no hit", "[lab2]") {
    requireHits();
    for (const TriangleCase& sample : triangleCases())
        for (const float height : {1.f, -2.f}) {
            const Ray there =
                rayTo(sample.shape, {0.25f, 0.5f}, sample.size * height * sample.normal);
            const Ray away(there.orig, -there.dir);
            expectMiss("turned away from", sample.shape, away,
                       isHit(sample.shape, there)
                           ? "a ray begins at its origin: where t is negative, it has not been"
                           : "the sign of t is turned round: positive t lies ahead of the ray's "
                             "origin");
        }
}

TEST_CASE("a triangle is no hit past the end of the ray", "[lab2]") {
    requireHits();
    expectWithin(0, FLT_MAX, true, "");
    expectWithin(0, 4.125f, true, "");
    expectWithin(0, 3.875f, false, past);
    expectWithin(0, 1, false, past);
}

TEST_CASE("a triangle is no hit before the beginning of the ray", "[lab2]") {
    requireHits();
    expectWithin(3.875f, FLT_MAX, true, "");
    expectWithin(-1, 5, true, "");
    expectWithin(4.125f, FLT_MAX, false, early);
    expectWithin(100, FLT_MAX, false, early);
}

TEST_CASE("a ray that starts on a triangle does not hit it", "[lab2]") {
    requireHits();
    for (const Vec3& along : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0.5f, 2)})
        expectMiss("which starts on", plainTriangle(), Ray({1, 1, 0}, along),
                   "t is 0 here, and a hit counts only where t is greater than minT, not equal");
}

TEST_CASE("an octahedron in the colours of its normals: the picture", "[lab2]") {
    const Vec3 x(2, 0, 0), y(0, 2, 0), z(0, 0, 2);
    std::vector<Triangle> faces;
    for (const Vec3& a : {x, -x})
        for (const Vec3& b : {y, -y})
            for (const Vec3& c : {z, -z}) faces.push_back(triangle(a, b, c));
    const auto seen = [&](Ray ray) {
        Color color(0.05f, 0.05f, 0.05f);
        for (const Triangle& face : faces) {
            Intersection hit;
            if (!face.intersect(ray, hit)) continue;
            color = (hit.normal + Vec3(1, 1, 1)) * 0.5f;
            ray.maxT = hit.hitT;
        }
        return color;
    };
    lab::expectPicture("lab2-octahedron",
                       lab::photo(Camera({3, 4, 7}, {0, 0, 0}, {0, 1, 0}, 32), seen), 2, 24,
                       {"an octahedron of eight triangles, each in a colour made of its normal",
                        "where too much or too little is covered, look at the tests of edges; "
                        "where a face has the wrong colour, at those of normal and t"});
}
