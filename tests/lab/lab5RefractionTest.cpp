#include "lab/bend.h"

using namespace lab;
using namespace sw;

// getRefractedRay(), asked directly.

namespace {

const std::vector<Bend> entering = {{true, 1.5f, 0.6f, 0.4f},
                                    {true, 1.25f, 0.5f, 0.4f},
                                    {true, 2, 0.48f, 0.24f},
                                    {true, 4 / 3.f, 0.6f, 0.45f},
                                    {true, 1.5f, 0.9f, 0.6f}};
const std::vector<Bend> leaving = {{false, 1.5f, 0.4f, 0.6f},
                                   {false, 1.25f, 0.4f, 0.5f},
                                   {false, 2, 0.24f, 0.48f},
                                   {false, 4 / 3.f, 0.6f, 0.8f},
                                   {false, 1.5f, 0.6f, 0.9f}};
// In a body that is optically thinner than what surrounds it, as a bubble in water.
const std::vector<Bend> bubbles = {{true, 0.75f, 0.6f, 0.8f}, {false, 0.75f, 0.8f, 0.6f}};

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
        expectAll({{true, index, 0, 0}, {false, index, 0, 0}});
    }
}

TEST_CASE("glass of index 1 is as good as air", "[lab5]") {
    for (const float sine : {0.1f, 0.5f, 0.9f, 0.99f}) {
        expectAll({{true, 1, sine, sine}, {false, 1, sine, sine}});
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
    expectAll({{false, 1.5f, 0.66f, 0.99f}, {false, 2, 0.495f, 0.99f}});
}

TEST_CASE("a window pane does not change a ray's direction", "[lab5]") {
    for (const float sine : {0.2f, 0.6f, 0.9f}) {
        for (const Place& place : places()) {
            const Crossing in{downwards(place, sine), place.normal, 1.5f, true};
            const Ray inside = in.asked();
            if (isEmpty(inside))
                fail({"a ray into a window pane", "an empty ray", "a refracted ray",
                      bendHint(inside, in)});
            const Crossing out{heading(inside.dir), place.normal, 1.5f, false};
            const Ray got = hitBy(inside.dir, out.n, glass(1, 1.5f), false).getRefractedRay();
            if (alike(got.dir, in.d)) continue;
            const bool entersRight = agree(heading(inside.dir), in.refracted());
            fail({"a ray with direction " + text(in.d) + " through a pane of glass with normal " +
                      text(place.normal),
                  "the direction " + text(got.dir), "the same as before",
                  entersRight ? bendHint(got, out) : bendHint(inside, in)});
        }
    }
}

namespace {

// Where Snell's law would ask for a sine above 1.
const std::vector<Bend> noWayOut = {{false, 1.5f, 0.8f, 1.2f},
                                    {false, 2, 0.6f, 1.2f},
                                    {false, 1.5f, 0.67f, 1.005f},
                                    {true, 0.5f, 0.6f, 1.2f}};

// NaN is the same as NaN here.
bool same(const Vec3& a, const Vec3& b) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= 1e-6f) && !(std::isnan(a[i]) && std::isnan(b[i])))
            return false;
    return true;
}
bool same(const Ray& a, const Ray& b) {
    return same(a.dir, b.dir) && same(a.orig, b.orig);
}

std::vector<BendSuspect> totalSuspects() {
    const std::string total = "where c < 0 no light gets through, and all of it is reflected";
    return {{[](const Crossing& x) { return x.formula(x.eta(), x.cosine(), std::fabs(x.c()), -1); },
             "the root of |c| has no meaning: " + total},
            {[](const Crossing& x) { return x.formula(x.eta(), x.cosine(), 0, -1); },
             "this ray slides along the surface: " + total},
            {[](const Crossing& x) { return x.d; }, "this ray goes straight on: " + total},
            {[](const Crossing& x) { return -x.d; },
             "this ray goes back the way it came: " + total + ", as by a mirror"},
            {[](const Crossing& x) { return x.n; },
             "this ray leaves along the normal: " + total + ", as by a mirror"},
            {[](const Crossing& x) { return -x.n; },
             "this ray gets through along the normal: " + total},
            {[](const Crossing& x) { return x.d + 2 * x.cosine() * x.n; },
             "this ray is reflected about the wrong side and dives deeper into the surface"},
            {[](const Crossing&) { return Vec3(0, 0, 0); },
             "this ray has no direction, so that the light gets lost: " + total}};
}

// For all cases without a way out at once; null if what comes out is right, or nobody knows why
// not.
const BendSuspect* totalCulprit() {
    static std::vector<BendSuspect> ways;
    ways = totalSuspects();
    for (BendSuspect& s : ways)
        s.yields = [yields = s.yields](const Crossing& x) { return heading(yields(x)); };
    std::vector<Crossing> cases;
    for (const Bend& bend : noWayOut)
        for (const Place& place : places()) cases.push_back(crossingOf(bend, place));
    return culprit(
        cases, [](const Crossing& x) { return heading(x.asked().dir); }, ways);
}

std::string noWayOutHint(const Ray& got, const Crossing& x) {
    if (isStarters(got) && !refractsAtAll()) return refractionNotYet;
    if (!isNumber(got.dir)) {
        return faultOf(got.dir) + (bendsRight()
                                       ? "; here c is negative: at this angle no ray gets through, "
                                         "all light is reflected"
                                       : "");
    }
    if (agree(got.dir, x.mirrored()))
        return "the totally reflected ray has to start on the side it came from";
    if (agree(heading(got.dir), x.mirrored()))
        return "the totally reflected ray has a direction of length 1 as well";
    if (const std::string hint = bendHint(got, x); !hint.empty()) return hint;
    const BendSuspect* mistake = totalCulprit();
    return mistake == nullptr ? "" : mistake->hint;
}

}  // namespace

TEST_CASE("where no ray gets out of the glass all light is reflected", "[lab5]") {
    for (const Bend& bend : noWayOut) {
        for (const Place& place : places()) {
            const Crossing x = crossingOf(bend, place);
            const Intersection hit = hitBy(x.d, x.n, glass(1, x.index), x.entering);
            const Ray got = hit.getRefractedRay();
            // Right or wrong, that is task 4: if it is the starter's, the refracted ray must be one
            // elsewhere.
            if (same(got, hit.getReflectedRay()) && (!isEmpty(got) || refractsAtAll())) continue;
            const Vec3 start = startOf(got) - hit.position;
            if (!isEmpty(got) && alike(got.dir, x.mirrored()) && start * place.normal > -1e-6f)
                continue;
            fail({tried(bend, place), "the direction " + text(got.dir),
                  "the mirrored direction " + text(x.mirrored()), noWayOutHint(got, x)});
        }
    }
}
