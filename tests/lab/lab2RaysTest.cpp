#include <cfloat>
#include <cmath>

#include "lab/photo.h"
#include "lab/triangleMistakes.h"

using namespace lab;
using namespace sw;

namespace {

const char* whyAccepted(const Intersection& hit) {
    return std::isnan(hit.hitT) ? ", and NaN answers every comparison with false" : "";
}

// No ray has any business with that triangle.
void expectMiss(const std::string& about, const Triangle& t, const Ray& ray,
                const std::string& whyFault) {
    Intersection hit;
    if (!t.intersect(ray, hit)) return;
    const std::string fault = faultOfHit(hit);
    fail({text(ray) + ", " + about + " " + text(t),
          "a hit at t = " + text(hit.hitT) + ", position " + text(hit.position), "no hit",
          fault.empty() ? "" : fault + whyFault + whyAccepted(hit)});
}

// In the plane or parallel to it.
void expectMissAlong(const std::string& about, const Triangle& t, const Ray& ray) {
    expectMiss(about, t, ray, "; n . d is 0 here");
}

void expect(const Asked& asked, const std::string& about) {
    Intersection hit;
    const bool found = asked.shape.intersect(asked.ray, hit), due = shouldHit(asked);
    if (found == due) return;
    const std::string fault = found ? faultOfHit(hit) : "";
    fail({about, found ? "a hit" : "no hit", due ? "a hit" : "no hit",
          fault.empty() ? whyWrong(asked) : fault});
}

// The plain triangle is met at t = 4.
void expectWithin(float minT, float maxT) {
    const Asked asked{
        plainTriangle(), Ray({1, 1, 2}, {0, 0, -0.5f}, minT, maxT), {0.25f, 0.25f}, 4};
    expect(asked, "a ray that meets " + text(plainTriangle()) +
                      " at t = 4, with minT = " + text(minT) + " and maxT = " + text(maxT));
}

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
                expectMissAlong("in the plane of", t, Ray(at(t, from), along));
            }
}

TEST_CASE("a ray parallel to a triangle is no hit", "[lab2]") {
    requireHits();
    const Triangle t = plainTriangle();
    for (const float height : {4.f, -4.f, 0.25f})
        for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(-2, 1, 0)})
            for (const Vec3& start : {Vec3(1, 1, 0), Vec3(-4, 0, 0), Vec3(4, 4, 0)})
                expectMissAlong("parallel to", t, Ray(start + Vec3(0, 0, height), along));
}

TEST_CASE("a triangle without area is never hit", "[lab2]") {
    requireHits();
    const Vec3 a(1, 0, 0), middle(2, 1, 1), b(3, 2, 2), origin(2, 1, 6);
    const char* hint = "; n is 0 here, as the vertices lie on a line";
    for (const Triangle& t : {triangle(a, a, a), triangle(a, a, b), triangle(a, b, a),
                              triangle(b, a, a), triangle(a, b, middle), triangle(a, middle, b)})
        for (const Vec3& target : {a, middle, b})
            expectMiss("without area:", t, Ray(origin, target - origin), hint);
}

TEST_CASE("a triangle behind the ray's origin is no hit", "[lab2]") {
    requireHits();
    for (const TriangleCase& sample : triangleCases())
        for (const float height : {1.f, -2.f}) {
            Asked asked =
                askedTo(sample.shape, {0.25f, 0.5f}, sample.size * height * sample.normal);
            asked.ray.dir = -asked.ray.dir;
            asked.t = -1;
            expect(asked, text(asked.ray) + ", turned away from " + text(sample.shape));
        }
}

TEST_CASE("a triangle is no hit past the end of the ray", "[lab2]") {
    requireHits();
    for (const float maxT : {FLT_MAX, 4.125f, 3.875f, 1.f}) expectWithin(0, maxT);
}

TEST_CASE("a triangle is no hit before the beginning of the ray", "[lab2]") {
    requireHits();
    expectWithin(3.875f, FLT_MAX);
    expectWithin(-1, 5);
    expectWithin(4.125f, FLT_MAX);
    expectWithin(100, FLT_MAX);
}

TEST_CASE("a ray that starts on a triangle does not hit it", "[lab2]") {
    requireHits();
    for (const Vec3& along : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0.5f, 2)}) {
        const Asked asked{plainTriangle(), Ray({1, 1, 0}, along), {0.25f, 0.25f}, 0};
        expect(asked, text(asked.ray) + ", which starts on " + text(asked.shape));
    }
}

TEST_CASE("what a record held before does not decide about a hit", "[lab2]") {
    requireHits();
    for (const float hitT : {-1.f, 0.f, 0.5f, 3.f, FLT_MAX})
        for (const float height : {4.f, -4.f}) {
            const Asked asked = askedTo(plainTriangle(), {0.25f, 0.25f}, {0, 0, height});
            Intersection hit;
            hit.hitT = hitT;
            if (asked.shape.intersect(asked.ray, hit)) continue;
            fail({text(asked.ray) + " to " + text(asked.shape) +
                      ", with a record that holds hitT = " + text(hitT) + " before",
                  "no hit", "a hit at t = 1",
                  isHit(asked.shape, asked.ray)
                      ? "with a fresh record it is a hit: the record is where the answer goes, and "
                        "how far the ray reaches only its maxT says"
                      : whyWrong(asked)});
        }
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
    lab::expectPicture(
        "lab2-octahedron", lab::photo(Camera({3, 4, 7}, {0, 0, 0}, {0, 1, 0}, 32), seen), 2, 24,
        {"an octahedron of eight triangles, each in a colour made of its normal", whyNeverHit()});
}
