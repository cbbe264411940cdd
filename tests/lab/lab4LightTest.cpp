#include "lab/mirrors.h"
#include "lab/photo.h"

using namespace lab;
using namespace sw;

// Mirrors among lights. How bright the lights make a surface is not asked here: the same surface is
// compared with itself.

namespace {

const std::string notYet =
    "nothing of what the mirrored ray sees arrives: traceRay() has to ask itself for it";

// A painted surface with a light at the eye, which sees the sky where it is mirrored.
Color lit(float r) {
    World world;
    const Vec3 eye(0, 0, 50);
    world.push(Pane(0, 1, opaque(r, Color(0.9f, 0.5f, 0.2f))));
    world.push(Light(eye, Color(1, 1, 1)));
    return world.colorOf(Ray(eye, Vec3(0, 0, -1)), 1);
}

std::string mixingHint(float r, const Color& matt, const Color& got) {
    return hintFor(
        got,
        {{(1 - r) * matt, notYet},
         {matt, notYet},
         {matt + r * sky,
          "the weights add up to more than 1: light that is mirrored cannot be scattered as well, "
          "so what a surface scatters has to get less by the part that it mirrors"},
         {(1 - r) * matt + sky, "the mirrored colour is added without its weight"},
         {matt + (1 - r) * (sky - matt), "the two weights are the wrong way round"},
         {(1 - r) * (matt + r * sky),
          "the mirrored colour was weakened too: only what the surface "
          "scatters gets less by the part that it mirrors"},
         {(1 - r) * (1 - r) * matt + r * sky, "the scattered light is weakened twice"}},
        "scattered and mirrored light share between them what falls in: together they weigh 1");
}

}  // namespace

TEST_CASE("scattered and mirrored light together weigh 1", "[lab4]") {
    const Color matt = lit(0);
    for (const float r : {1.f, 0.75f, 0.25f}) {
        const Color got = lit(r), expected = (1 - r) * matt + r * sky;
        if (alike(got, expected, 1e-4f * (1 + matt.norm()))) continue;
        fail({"a lit surface of reflectivity " + text(r) + " that mirrors a sky of colour " +
                  text(sky) + "; with reflectivity 0 it is " + text(matt),
              text(got), text(expected), mixingHint(r, matt, got)});
    }
}

namespace {

enum class Lights { none, lit, hidden };

// A perfect mirror that shows the sky; a black ball may stand between it and a light.
Color mirrorUnder(Lights lights) {
    World world;
    world.push(Pane(0, 1, opaque(1, Color(0.9f, 0.5f, 0.2f))));
    if (lights != Lights::none) world.push(Light(Vec3(0, 0, 100), Color(1, 1, 1)));
    if (lights == Lights::hidden) world.push(Sphere(Vec3(0, 0, 50), 10, opaque()));
    return world.colorOf(Ray(Vec3(-50, 0, 50), Vec3(1, 0, -1)), 1);
}

// Whether a matt surface in the shadow of one light looks as if only the other one were there. If
// not, that is a mistake of task 3, and blackens mirrors as well.
bool shadowsAreRight() {
    const auto matt = [](bool both) {
        World world;
        world.push(Pane(0, 1, opaque(0, Color(0.9f, 0.5f, 0.2f))));
        if (both) world.push(Light(Vec3(0, 0, 100), Color(1, 1, 1)));
        world.push(Light(Vec3(-100, 0, 60), Color(1, 1, 1)));
        world.push(Sphere(Vec3(0, 0, 50), 10, opaque()));
        return world.colorOf(Ray(Vec3(-50, 0, 50), Vec3(1, 0, -1)), 1);
    };
    return alike(matt(true), matt(false));
}

}  // namespace

TEST_CASE("a mirror in the shadow still mirrors", "[lab4]") {
    const Color got = mirrorUnder(Lights::hidden);
    if (alike(got, sky, 1e-3f)) return;
    const Color unlit = mirrorUnder(Lights::none);
    if (alike(unlit, sky) && !shadowsAreRight()) return;
    const std::string more = "a perfect mirror scatters nothing, so lights change nothing on it";
    const std::string dark =
        "black is returned in the shadow before the mirror has its turn: a "
        "shadow takes one light's scattered light away and nothing else";
    fail({"a perfect mirror in a ball's shadow; without lights it shows " + text(unlit), text(got),
          text(sky), !alike(unlit, sky) ? notYet : hintFor(got, {{Color(0, 0, 0), dark}}, more)});
}

TEST_CASE("mirror balls among black balls: the picture", "[lab4]") {
    World world;
    const auto add = [&](float x, float y, float z, float radius, float r) {
        world.push(Sphere(Vec3(x, y, z), radius, opaque(r)));
    };
    add(-11, 5, 0, 8, 0.9f);
    add(9, 8, -6, 9, 0.6f);
    add(6, -10, 4, 6, 1);
    add(-9, -12, 8, 4, 0.3f);
    add(-2, 1, 14, 2.5f, 0);
    add(0, -9, 14, 2, 0);
    add(1, 16, 10, 3, 0);
    add(17, -4, 6, 3, 0);
    add(-18, -4, 8, 3, 0);
    const Image image = photo(Camera(Vec3(0, 0, 70), Vec3(0, 0, 0), Vec3(0, 1, 0), 40),
                              [&](const Ray& ray) { return world.colorOf(ray, 4); });
    expectPicture("lab4-mirrors", image, 3, 20,
                  {"four mirror balls and five black ones under the sky",
                   "each ball mirrors all the others, and balls that mirror it: if the other tests "
                   "of this task pass, look at how the depth is handed on"});
}
