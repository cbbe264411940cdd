#include "lab/bend.h"

using namespace lab;
using namespace sw;

// getRefractedRay(), asked directly.

namespace {

const std::vector<Bend> entering = {{true, 1.5f, 0.6f, 0.4f, 0.9f},
                                    {true, 1.25f, 0.5f, 0.4f, 0.625f},
                                    {true, 2, 0.48f, 0.24f, 0.96f},
                                    {true, 4 / 3.f, 0.6f, 0.45f, 0.8f},
                                    {true, 1.5f, 0.9f, 0.6f, 1.35f}};
const std::vector<Bend> leaving = {{false, 1.5f, 0.4f, 0.6f, 4 / 15.f},
                                   {false, 1.25f, 0.4f, 0.5f, 0.32f},
                                   {false, 2, 0.24f, 0.48f, 0.12f},
                                   {false, 4 / 3.f, 0.6f, 0.8f, 0.45f},
                                   {false, 1.5f, 0.6f, 0.9f, 0.4f}};
// In a body that is optically thinner than what surrounds it, as a bubble in water.
const std::vector<Bend> bubbles = {{true, 0.75f, 0.6f, 0.8f, 0.45f},
                                   {false, 0.75f, 0.8f, 0.6f, 16 / 15.f}};

void expectAll(const std::vector<Bend>& bends) {
    for (const Bend& bend : bends)
        for (const Place& place : places()) expectBend(bend, place);
}

}  // namespace

TEST_CASE("a ray that enters glass bends towards the normal", "[lab5]") {
    expectAll(entering);
}

TEST_CASE("a ray that leaves glass bends away from the normal", "[lab5]") {
    expectAll(leaving);
}

TEST_CASE("in a bubble a ray bends the other way", "[lab5]") {
    expectAll(bubbles);
}

TEST_CASE("a ray that meets glass head-on goes straight on", "[lab5]") {
    for (const float index : {0.5f, 1.f, 1.3f, 2.4f}) {
        expectAll({{true, index, 0, 0, 0}, {false, index, 0, 0, 0}});
    }
}

TEST_CASE("glass of index 1 is as good as air", "[lab5]") {
    for (const float sine : {0.1f, 0.5f, 0.9f, 0.99f}) {
        expectAll({{true, 1, sine, sine, sine}, {false, 1, sine, sine, sine}});
    }
}

TEST_CASE("the length of the incoming direction does not matter to glass", "[lab5]") {
    for (const float length : {0.01f, 0.5f, 3.f, 100.f}) {
        for (const Place& place : places()) {
            expectBend(entering[0], place, length);
            expectBend(leaving[0], place, length);
        }
    }
}

TEST_CASE("just before total reflection a ray still gets out", "[lab5]") {
    // 2/3 is the greatest sine in glass of index 1.5 with which light gets out, 1/2 in that of 2.
    expectAll({{false, 1.5f, 0.66f, 0.99f, 0.44f}, {false, 2, 0.495f, 0.99f, 0.2475f}});
}

TEST_CASE("a window pane does not change a ray's direction", "[lab5]") {
    for (const float sine : {0.2f, 0.6f, 0.9f}) {
        for (const Place& place : places()) {
            const Vec3 in = downwards(place, sine);
            const Ray inside = hitBy(in, place.normal, glass(1, 1.5f), true).getRefractedRay();
            if (isEmpty(inside))
                fail({"a ray into a window pane", "an empty ray", "a refracted ray",
                      refractionNotYet});
            const Vec3 got =
                hitBy(inside.dir, place.normal, glass(1, 1.5f), false).getRefractedRay().dir;
            if (alike(got, in)) continue;
            fail({"a ray with direction " + text(in) + " through a pane of glass with normal " +
                      text(place.normal),
                  "the direction " + text(got), "the same as before",
                  "what the first surface bends, the second one bends back: is frontFacing asked, "
                  "which tells the way in from the way out?"});
        }
    }
}

namespace {

// Where Snell's law would ask for a sine above 1.
const std::vector<Bend> noWayOut = {{false, 1.5f, 0.8f, 1.2f, 0.5333f},
                                    {false, 2, 0.6f, 1.2f, 0.3f},
                                    {false, 1.5f, 0.67f, 1.005f, 0.4467f},
                                    {true, 0.5f, 0.6f, 1.2f, 0.3f}};

bool same(const Ray& a, const Ray& b) {
    return alike(a.dir, b.dir, 1e-6f) && alike(a.orig, b.orig, 1e-6f);
}

std::string noWayOutHint(const Ray& got, const Bend& bend, const Place& place) {
    if (isEmpty(got)) return refractionNotYet;
    if (!isNumber(got.dir)) {
        return "the root of a negative number: at this angle no ray gets through, all light stays "
               "on its side as if the surface were a mirror";
    }
    const Vec3 g = unit(got.dir);
    if (alike(g, downwards(place, bend.inverted))) return invertedHint(bend.entering);
    if (alike(g, upwards(place, bend.sineIn))) {
        return alike(got.dir, g) ? "the totally reflected ray has to start on the side it came from"
                                 : "the totally reflected ray has a direction of length 1 as well";
    }
    return "this ray pretends to get through: where Snell's law asks for a sine above 1 there is "
           "no refracted ray, and all light is reflected";
}

}  // namespace

TEST_CASE("where no ray gets out of the glass all light is reflected", "[lab5]") {
    for (const Bend& bend : noWayOut) {
        for (const Place& place : places()) {
            const Intersection hit = hitBy(bend, place);
            const Ray got = hit.getRefractedRay();
            // Right or wrong, that is task 4.
            if (same(got, hit.getReflectedRay())) {
                if (!isEmpty(got)) continue;
                // The starter's: then the refracted ray must be one elsewhere.
                if (!isEmpty(
                        hitBy(place.normal * -1, place.normal, glass(1, 1.5f)).getRefractedRay()))
                    continue;
            }
            const Vec3 expected = upwards(place, bend.sineIn);
            const Vec3 start = got.orig + got.minT * got.dir - hit.position;
            if (!isEmpty(got) && alike(got.dir, expected) && start * place.normal > -1e-6f)
                continue;
            fail({tried(bend, place), "the direction " + text(got.dir),
                  "the mirrored direction " + text(expected), noWayOutHint(got, bend, place)});
        }
    }
}
