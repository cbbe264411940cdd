#include "lab/mirrors.h"

using namespace lab;
using namespace sw;

// traceRay() and mirrors: what it adds, and how often it calls itself.

namespace {

// Falls onto the middle of a mirror at z = 0, and would be mirrored to the right.
const Ray slanting(Vec3(-50, 0, 50), Vec3(1, 0, -1));
const Ray plumb(Vec3(0, 0, 50), Vec3(0, 0, -1));

const std::string notYet =
    "nothing of what the mirrored ray sees arrives: traceRay() has to ask itself for it";

Color seenInMirror(float r, const Color& paint = Color(0, 0, 0)) {
    World world;
    world.push(Pane(0, 1, opaque(r, paint)));
    return world.colorOf(slanting, 1);
}

std::string mirrorOf(float r) {
    return "a mirror of reflectivity " + text(r) + " under a sky of colour " + text(sky);
}

}  // namespace

TEST_CASE("a perfect mirror shows the sky", "[lab4]") {
    const Color got = seenInMirror(1);
    if (alike(got, sky)) return;
    fail({mirrorOf(1), text(got), text(sky),
          hintFor(got, {{Color(0, 0, 0), notYet}},
                  "a perfect mirror brings back just what its mirrored ray sees")});
}

TEST_CASE("a mirror weakens what it shows by its reflectivity", "[lab4]") {
    const Color paint(0.5f, 0.2f, 1);
    for (const float r : {0.1f, 0.25f, 0.6f, 0.9f}) {
        const Color got = seenInMirror(r, paint), expected = r * sky;
        if (alike(got, expected)) continue;
        fail({mirrorOf(r), text(got), text(expected),
              hintFor(got,
                      {{Color(0, 0, 0), notYet},
                       {sky,
                        "what arrives is as bright as in a perfect mirror: it has to be "
                        "weighted by the reflectivity"},
                       {(1 - r) * sky,
                        "the two weights are the wrong way round: the more reflective a surface, "
                        "the more of the mirrored ray and the less of its own colour it shows"},
                       {r * r * sky, "the reflectivity is multiplied in twice"},
                       {r * paint.times(sky),
                        "a mirror shows things in their own colours: the surface's colour belongs "
                        "to the scattered light alone"}},
                      "the mirrored ray's colour counts in proportion to the reflectivity")});
    }
}

TEST_CASE("a mirror shows what lies in the mirrored direction", "[lab4]") {
    struct Case {
        Vec3 ball;
        Color expected;
        std::string where, hint;
    };
    const Case cases[] = {
        {{50, 0, 50},
         {0, 0, 0},
         "where the mirrored ray goes",
         "the sky shows where a black ball should be mirrored: does the ray that traceRay() "
         "follows come from getReflectedRay()?"},
        {{50, 0, -50},
         sky,
         "behind the mirror, straight on",
         "a mirror hides what is behind it: follow the mirrored ray, not the one that came in"},
        {{0, 0, 50},
         sky,
         "straight above the mirror",
         "the mirrored ray does not leave along the normal, but at the angle at which it came"},
        {{-50, 50, 50},
         sky,
         "beside the eye",
         "the ray that traceRay() follows goes nowhere near what is mirrored"}};
    for (const Case& c : cases) {
        World world;
        world.push(Pane(0, 1, opaque(1)));
        world.push(Sphere(c.ball, 10, opaque()));
        const Color got = world.colorOf(slanting, 1);
        if (alike(got, c.expected)) continue;
        fail({"a perfect mirror and a black ball " + c.where, text(got), text(c.expected),
              alike(seenInMirror(1), sky) ? c.hint : notYet});
    }
}

TEST_CASE("light that is mirrored k times is weakened k times", "[lab4]") {
    // Up and down between a floor and a ceiling that end after k mirrored points.
    for (const int k : {1, 2, 3, 4}) {
        World world;
        const float end = 10 * (static_cast<float>(k) - 0.5f);
        world.push(Pane(0, 1, opaque(0.5f), end));
        world.push(Pane(10, -1, opaque(0.5f), end));
        const Color got = world.colorOf(Ray(Vec3(-5, 0, 5), Vec3(1, 0, -1)), 6);
        const Color expected = std::ldexp(1.f, -k) * sky;
        if (alike(got, expected)) continue;
        fail({"a ray that meets mirrors of reflectivity 0.5 " + std::to_string(k) +
                  " times before it reaches the sky of colour " + text(sky),
              text(got), text(expected),
              hintFor(got,
                      {{Color(0, 0, 0), notYet},
                       {0.5f * sky,
                        "only one of the mirrors counts: what a mirror shows may be a "
                        "mirror again"}},
                      "each call of traceRay() weights what its own mirrored ray brings")});
    }
}

namespace {

// Mirrors at z = 0 and z = 100, face to face.
World corridor() {
    World world;
    world.push(Pane(0, 1, opaque(1)));
    world.push(Pane(100, -1, opaque(1)));
    return world;
}

// The rays between the two mirrors. Other rays go out through one of them.
int countBetween(const std::vector<Ray>& rays) {
    int sum = 0;
    for (const Ray& ray : rays) {
        const bool up = ray.orig[2] < 50 && ray.dir[2] > 0;
        const bool down = ray.orig[2] >= 50 && ray.dir[2] < 0;
        sum += (up || down) && !isEmpty(ray);
    }
    return sum;
}

std::string countHint(bool endless, int count, int depth) {
    World world = corridor();
    Color color;
    if (!world.trace(plumb, 0, color) || countBetween(world.rays()) > 1) {
        return "the recursion has no end: nothing asks whether there is any depth left before the "
               "mirrored ray is traced, and at depth 0 no more rays may follow";
    }
    if (endless) {
        return "the depth never gets less: each call hands on what it was given itself, so that "
               "the end is never reached; one less is left with each mirror";
    }
    if (count == 1) return notYet;
    return count <= depth ? "the recursion ends too early: with depth 1 there is one mirrored ray"
                          : "one ray comes from the eye, and each step of depth allows one more";
}

}  // namespace

TEST_CASE("between two mirrors a ray is followed as often as the depth allows", "[lab4]") {
    for (int depth = 5; depth >= 0; --depth) {
        World world = corridor();
        Color color;
        const bool endless = !world.trace(plumb, depth, color);
        const int count = countBetween(world.rays());
        if (!endless && count == depth + 1) continue;
        fail({"two perfect mirrors face to face, with depth " + std::to_string(depth),
              endless ? "rays without end" : std::to_string(count) + " rays",
              std::to_string(depth + 1) + " rays: one from the eye, then one per step of depth",
              countHint(endless, count, depth)});
    }
}

TEST_CASE("no mirrored ray is traced where nothing is reflective", "[lab4]") {
    const auto countUpwards = [](float r) {
        World world;
        world.push(Pane(0, 1, opaque(r)));
        world.colorOf(plumb, 3);
        int sum = 0;
        for (const Ray& ray : world.rays()) sum += ray.dir[2] > 0 && !isEmpty(ray);
        return sum;
    };
    if (const int wasted = countUpwards(0); wasted > 0) {
        fail({"a surface of reflectivity 0", std::to_string(wasted) + " mirrored ray",
              "no mirrored ray",
              "what has no weight changes no picture but takes its time: when all surfaces send on "
              "rays that count for nothing, their number multiplies with every step of depth"});
    }
    const int useful = countUpwards(0.01f);
    if (useful == 1) return;
    fail({"a surface of reflectivity 0.01", std::to_string(useful) + " mirrored rays", "one",
          useful == 0 ? notYet : "one mirrored ray is enough"});
}
