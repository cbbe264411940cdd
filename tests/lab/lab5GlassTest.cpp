#include "lab/mirrors.h"

using namespace lab;
using namespace sw;

// traceRay() and glass: what it adds, and how often it calls itself.

namespace {

const Ray plumb(Vec3(0, 0, 50), Vec3(0, 0, -1));

const std::string notYet =
    "nothing of what the refracted ray sees arrives: traceRay() has to ask itself for it";
const std::string indexHint =
    "the refractive index is taken for the transparency: the index bends rays, the transparency "
    "tells how much light gets through";

// Panes of glass one below the other, ten apart.
World panes(int count, const Material& material) {
    World world;
    for (int i = 0; i < count; ++i) world.push(Pane(-10.f * static_cast<float>(i), 1, material));
    return world;
}

std::string glassOf(float t) {
    return "glass of transparency " + text(t) + " and index 1.3 before a sky of colour " +
           text(sky);
}

}  // namespace

TEST_CASE("perfect glass shows the sky behind it", "[lab5]") {
    const Color got = panes(1, glass(1, 1.3f)).colorOf(plumb, 1);
    if (alike(got, sky)) return;
    fail({glassOf(1), text(got), text(sky),
          hintFor(got, {{Color(0, 0, 0), notYet}, {1.3f * sky, indexHint}},
                  "perfect glass brings back just what its refracted ray sees")});
}

TEST_CASE("glass weakens what it shows by its transparency", "[lab5]") {
    const Color paint(0.5f, 0.2f, 1);
    for (const float t : {0.1f, 0.25f, 0.6f, 0.9f}) {
        const Color got = panes(1, glass(t, 1.3f, paint)).colorOf(plumb, 1), expected = t * sky;
        if (alike(got, expected)) continue;
        fail({glassOf(t), text(got), text(expected),
              hintFor(got,
                      {{Color(0, 0, 0), notYet},
                       {1.3f * sky, indexHint},
                       {1.3f * t * sky, indexHint},
                       {sky,
                        "what arrives is as bright as through perfect glass: it has to be "
                        "weighted by the transparency"},
                       {(1 - t) * sky,
                        "the two weights are the wrong way round: the more "
                        "transparent the glass, the more of the sky it shows"},
                       {t * t * sky, "the transparency is multiplied in twice"},
                       {t * paint.times(sky),
                        "the surface's colour belongs to the light that it "
                        "scatters: what is behind keeps its own colours"}},
                      "the refracted ray's colour counts in proportion to the transparency")});
    }
}

TEST_CASE("light that gets through k panes is weakened k times", "[lab5]") {
    for (const int k : {2, 3, 4}) {
        const Color got = panes(k, glass(0.75f, 1.3f)).colorOf(plumb, 6);
        const float weight = std::pow(0.75f, static_cast<float>(k));
        if (alike(got, weight * sky)) continue;
        fail({std::to_string(k) + " panes of transparency 0.75 before a sky of colour " + text(sky),
              text(got), text(weight * sky),
              hintFor(got,
                      {{Color(0, 0, 0), notYet},
                       {std::pow(1.3f, static_cast<float>(k)) * sky, indexHint},
                       {0.75f * sky, "only one pane counts: behind glass there may be glass"}},
                      "each call of traceRay() weights what its own refracted ray brings")});
    }
}

TEST_CASE("a ball under water is seen where the bent ray goes", "[lab5]") {
    // Water of index 4/3: the sine 0.8 of the ray becomes 0.6.
    struct Case {
        Vec3 ball;
        Color expected;
        std::string where, hint;
    };
    const Case cases[] = {
        {{60, 0, -80},
         {0, 0, 0},
         "where the refracted ray goes",
         "the sky shows in place of the ball: does the ray that traceRay() follows come from "
         "getRefractedRay()?"},
        {{80, 0, -60},
         sky,
         "where the ray would go without water",
         "the ray that traceRay() follows goes straight on: water bends it towards the normal"},
        {{80, 0, 60},
         sky,
         "where the ray would go if the water were a mirror",
         "the ray that traceRay() follows is the mirrored one"}};
    for (const Case& c : cases) {
        World world = panes(1, glass(1, 4 / 3.f));
        world.push(Sphere(c.ball, 10, opaque()));
        const Color got = world.colorOf(Ray(Vec3(-40, 0, 30), Vec3(0.8f, 0, -0.6f)), 1);
        if (alike(got, c.expected)) continue;
        fail({"clear water and a black ball " + c.where, text(got), text(c.expected),
              hintFor(got, {{4 / 3.f * sky, indexHint}},
                      panes(1, glass(1, 1)).colorOf(plumb, 1).isZero() ? notYet : c.hint)});
    }
}

namespace {

// The rays that go down, as those through the panes do.
int countDown(const std::vector<Ray>& rays) {
    int sum = 0;
    for (const Ray& ray : rays) sum += ray.dir[2] < 0 && !isEmpty(ray);
    return sum;
}

int countThrough(int depth) {
    World world = panes(8, glass(0.5f, 1.3f));
    world.colorOf(plumb, depth);
    return countDown(world.rays());
}

std::string countHint(int count, int depth) {
    if (countThrough(0) > 1) {
        return "nothing asks whether there is any depth left before the refracted ray is traced: "
               "at depth 0 no more rays may follow";
    }
    if (count == 1) return notYet;
    if (count == 9) {
        return "the depth never gets less: each call hands on what it was given itself; one less "
               "is left behind each pane";
    }
    return count <= depth ? "the recursion ends too early: with depth 1 there is one refracted ray"
                          : "one ray comes from the eye, and each step of depth allows one more";
}

}  // namespace

TEST_CASE("a ray goes through as many panes as the depth allows", "[lab5]") {
    for (int depth = 4; depth >= 0; --depth) {
        const int count = countThrough(depth);
        if (count == depth + 1) continue;
        fail({"8 panes of glass in a row, with depth " + std::to_string(depth),
              std::to_string(count) + " rays", std::to_string(depth + 1) + " rays",
              countHint(count, depth)});
    }
}

TEST_CASE("no refracted ray is traced where nothing is transparent", "[lab5]") {
    World opaqueWorld = panes(1, glass(0, 1.3f));
    const Color color = opaqueWorld.colorOf(plumb, 3);
    if (const int wasted = countDown(opaqueWorld.rays()) - 1; wasted > 0) {
        fail({"a surface of transparency 0 and index 1.3",
              std::to_string(wasted) + " refracted ray, and the colour " + text(color),
              "no refracted ray",
              alike(color, 1.3f * sky)
                  ? indexHint
                  : "what has no weight changes no picture but takes its time: when all surfaces "
                    "send on rays that count for nothing, their number multiplies with every step "
                    "of depth"});
    }
    World clear = panes(1, glass(0.01f, 1.3f));
    clear.colorOf(plumb, 3);
    const int useful = countDown(clear.rays()) - 1;
    if (useful == 1) return;
    fail({"a surface of transparency 0.01", std::to_string(useful) + " refracted rays", "one",
          useful == 0 ? notYet : "one refracted ray is enough"});
}
