#include "lab/mirrors.h"

using namespace lab;
using namespace sw;

// Glass that also scatters or mirrors. How bright is not asked here: the same surface is compared
// with itself.

namespace {

const float glassIndex = 1.3f;

// A painted surface before the sky, with a light at the eye.
Color lit(float t) {
    World world;
    const Vec3 eye(0, 0, 50);
    world.push(Pane(0, 1, glass(t, glassIndex, Color(0.9f, 0.5f, 0.2f))));
    world.push(Light(eye, Color(1, 1, 1)));
    return world.colorOf(Ray(eye, Vec3(0, 0, -1)), 1);
}

std::string mixingHint(float t, const Color& matt, const Color& got) {
    return hintFor(
        got,
        {{(1 - t) * matt,
          "nothing of what the refracted ray sees arrives: traceRay() has to ask itself for it"},
         {matt,
          "nothing of what the refracted ray sees arrives: traceRay() has to ask itself for it"},
         {(1 - glassIndex) * matt + glassIndex * sky,
          "the refractive index is taken for the transparency: the index bends rays, the "
          "transparency tells how much light gets through"},
         {matt + t * sky,
          "the weights add up to more than 1: light that gets through cannot be scattered as "
          "well, so what a surface scatters has to get less by the part that gets through"},
         {(1 - t) * matt + sky, "the refracted colour is added without its weight"},
         {matt + (1 - t) * (sky - matt), "the two weights are the wrong way round"},
         {(1 - t) * (matt + t * sky),
          "the refracted colour was weakened too: only what the surface scatters gets less by the "
          "part that gets through"},
         {(1 - t) * (1 - t) * matt + t * sky, "the scattered light is weakened twice"}},
        "scattered and refracted light share between them what falls in: together they weigh 1");
}

}  // namespace

TEST_CASE("scattered and refracted light together weigh 1", "[lab5]") {
    const Color matt = lit(0);
    for (const float t : {1.f, 0.75f, 0.25f}) {
        const Color got = lit(t), expected = (1 - t) * matt + t * sky;
        if (alike(got, expected, 1e-4f * (1 + matt.norm()))) continue;
        fail({"a lit surface of transparency " + text(t) + " before a sky of colour " + text(sky) +
                  "; with transparency 0 it is " + text(matt),
              text(got), text(expected), mixingHint(t, matt, got)});
    }
}

TEST_CASE("what gets through comes on top of what is mirrored", "[lab5]") {
    const float r = 0.25f, t = 0.5f;
    const auto seen = [&](float transparency) {
        World world;
        world.push(Pane(0, 1, Material(Color(0, 0, 0), r, transparency, glassIndex)));
        return world.colorOf(Ray(Vec3(-50, 0, 50), Vec3(1, 0, -1)), 1);
    };
    const Color opaqueColor = seen(0);
    const Color got = seen(t) - opaqueColor, expected = t * sky;
    if (alike(got, expected)) return;
    fail(
        {"glass of reflectivity 0.25 and transparency 0.5 without lights; with transparency 0 it "
         "is " +
             text(opaqueColor),
         text(got) + " more than that", text(expected) + " more than that",
         hintFor(got,
                 {{t * (sky - opaqueColor),
                   "the mirrored light was weakened as well: what gets through is missing from "
                   "the scattered light alone, as reflectivity, transparency and the rest add up "
                   "to 1"},
                  {Color(0, 0, 0),
                   "nothing of what the refracted ray sees arrives: traceRay() "
                   "has to ask itself for it"}},
                 "the refracted ray's colour counts in proportion to the transparency, whatever "
                 "else the surface does")});
}
