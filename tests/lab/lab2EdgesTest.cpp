#include <array>
#include <utility>

#include "lab/triangleMistakes.h"

using namespace lab;
using namespace sw;

namespace {

void expectMiss(const TriangleCase& sample, const Barycentric& place) {
    for (const float height : {1.f, -2.f})
        for (const float slant : {0.f, 0.5f}) {
            const Vec3 away = sample.size * (height * sample.normal + slant * sample.across);
            const Asked asked = askedTo(sample.shape, place, away, height < 0 ? 2 : 0.5f);
            Intersection hit;
            if (!asked.shape.intersect(asked.ray, hit)) continue;
            const std::string fault = faultOfHit(hit);
            fail({text(asked.ray) + " beside " + text(asked.shape), "a hit at " + text(place),
                  "no hit", fault.empty() ? whyWrong(asked) : fault});
        }
}

void expectMisses(const std::vector<Barycentric>& places) {
    requireHits();
    for (const TriangleCase& sample : triangleCases())
        for (const Barycentric& place : places) expectMiss(sample, place);
}

// The eight triangles of a square of side 8 around its middle, in one of the coordinate planes.
// All numbers are whole or halved again and again, so that floats lose nothing.
std::vector<Triangle> fan(int axis, int first, bool turned) {
    const std::array<std::pair<float, float>, 8> rim = {
        {{4, -4}, {4, 0}, {4, 4}, {0, 4}, {-4, 4}, {-4, 0}, {-4, -4}, {0, -4}}};
    const auto point = [&](float a, float b) {
        Vec3 p;
        p[(axis + 1) % 3] = a;
        p[(axis + 2) % 3] = b;
        return p;
    };
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < 8; ++i) {
        const auto [a, b] = rim[i];
        const auto [c, d] = rim[(i + 1) % 8];
        std::array<Vec3, 3> v = {point(0, 0), point(a, b), point(c, d)};
        if (turned) std::swap(v[1], v[2]);
        const auto k = static_cast<std::size_t>(first);
        triangles.push_back(triangle(v[k], v[(k + 1) % 3], v[(k + 2) % 3]));
    }
    return triangles;
}

// The triangle's side that a place on it is on: whether the ray hits just beside that.
bool hitsInward(const Triangle& t, const Vec3& place, const Vec3& away) {
    const Vec3 middle = (t.vertices[0] + t.vertices[1] + t.vertices[2]) * (1 / 3.f);
    return isHit(t, Ray(place + 0.125f * (middle - place) + away, -away));
}

// Why neither of two neighbours is hit on their common edge.
std::string whyCracked(const std::vector<Triangle>& triangles, const Vec3& place,
                       const Vec3& away) {
    int near = 0, inward = 0;
    std::string why;
    for (const Triangle& t : triangles) {
        const Asked asked{t, Ray(place + away, -away), placeOf(t, place), 1};
        if (!shouldHit(asked)) continue;
        ++near;
        inward += hitsInward(t, place, away);
        if (why.empty()) why = whyWrong(asked);
    }
    return inward == near ? "on an edge v, w or 1 - v - w is exactly 0: both neighbours leave "
                            "their edge out here, and rays slip through the crack between them"
                          : why;
}

void expectNoCrack(const std::vector<Triangle>& triangles, const Vec3& place, const Vec3& away) {
    const Ray ray(place + away, -away);
    for (const Triangle& t : triangles)
        if (isHit(t, ray)) return;
    fail({text(ray) + " to " + text(place) + ", a point of an edge that two triangles share",
          "no hit on either of them", "a hit on at least one", whyCracked(triangles, place, away)});
}

}  // namespace

TEST_CASE("a ray beside a triangle but near it misses", "[lab2]") {
    expectMisses({{-0.25f, 0.5f},
                  {0.5f, -0.25f},
                  {-0.25f, -0.25f},
                  {-0.125f, 0.125f},
                  {0.25f, -0.5f},
                  {-0.3f, 0.4f}});
}

TEST_CASE("a ray past the side opposite to the first vertex misses", "[lab2]") {
    expectMisses({{0.75f, 0.75f}, {0.5f, 0.625f}, {1, 0.25f}, {0.125f, 1}});
}

TEST_CASE("a ray past a corner of a triangle misses", "[lab2]") {
    expectMisses({{1.25f, -0.125f}, {-0.125f, 1.25f}, {1.125f, 0}, {0, 1.125f}, {-0.125f, -0.5f}});
}

TEST_CASE("a ray that meets the plane far from the triangle misses", "[lab2]") {
    expectMisses({{3, 3}, {-5, 2}, {1, -6}, {-7, 7.5f}, {20, 0.25f}, {-4, -4}});
}

TEST_CASE("no ray slips through the edge between two triangles", "[lab2]") {
    requireHits();
    for (int axis = 0; axis < 3; ++axis)
        for (const int first : {0, 1, 2})
            for (const bool turned : {false, true}) {
                const std::vector<Triangle> triangles = fan(axis, first, turned);
                for (const float height : {8.f, -8.f})
                    for (const float slant : {0.f, 4.f}) {
                        Vec3 away(slant, slant, slant);
                        away[axis] = height;
                        // Edges along the axes, and the diagonals.
                        for (float s = -3.75f; s < 4; s += 0.25f)
                            for (const auto& [a, b] : {std::pair(s, 0.f), std::pair(0.f, s),
                                                       std::pair(s, s), std::pair(s, -s)}) {
                                Vec3 place;
                                place[(axis + 1) % 3] = a;
                                place[(axis + 2) % 3] = b;
                                expectNoCrack(triangles, place, away);
                            }
                    }
            }
}
