#include "lab/lightAndFloor.h"

using namespace lab;
using namespace sw;

namespace {

constexpr const char* beyondLight =
    "what stands beyond a light does not hide it: the shadow ray has to end at the light";

constexpr const char* tooShort =
    "the shadow ray ends before it is at the light: maxT counts in units of the direction, as t "
    "does";

const Light above({0, 0, 6});

std::string about(const Vec3& centre) {
    return "the floor's point (0, 0, 0) under a light at (0, 0, 6), with a ball of radius 0.5 at " +
           lab::text(centre);
}

// Of the floor's point (0, 0, 0); with a thing in the scene, or without.
Color seen(const std::vector<Light>& lights, const std::vector<Sphere>& things, int depth = 0) {
    Scene scene = floorUnder(lights);
    for (const Sphere& sphere : things) scene.push(sphere);
    return lookAt(scene, {0, 0, 0}, depth);
}

// What the student's own shading gives where nothing stands in the way. The tests of this task
// compare with it, so that they do not depend on task 1; but black would tell nothing.
Color unshadowed(const std::vector<Light>& lights) {
    const Color color = seen(lights, {});
    if (isBlack(color))
        fail({"a floor under a light at (0, 0, 6) and nothing else", "black", "any other colour",
              isBlack(seen(lights, {thing({0, 0, 3})}))
                  ? "nothing stands in the way of the light: is this a shadow, or task 1?"
                  : "lit and shadowed are exchanged: a light is passed over where something is in "
                    "the way"});
    return color;
}

void requireShadows() {
    unshadowed({above});
    requireAnyShadow();
}

// The hint is for those whose shadows are right where it is easiest.
void expectBlack(const std::string& tried, const Color& got, const char* hint) {
    if (isBlack(got)) return;
    const bool easiest = isBlack(seen({above}, {thing({0, 0, 3})}));
    fail({tried, "the colour " + lab::text(got), "black", easiest ? hint : tooShort});
}

void expectLit(const std::string& tried, const Color& got, const Color& lit, const char* hint) {
    if (!same(got, lit))
        fail({tried, "the colour " + lab::text(got), lab::text(lit) + ", as without it", hint});
}

}  // namespace

TEST_CASE("what stands between a surface and a light hides it", "[lab3]") {
    requireShadows();
    for (const float height : {0.75f, 1.5f, 3.f, 4.5f, 5.25f, 6.f}) {
        const Vec3 centre(0, 0, height);
        expectBlack(about(centre), seen({above}, {thing(centre)}),
                    height > 1 ? tooShort
                               : "things near the surface are overlooked: does the shadow ray "
                                 "begin just off the surface?");
    }
}

TEST_CASE("what stands beyond a light casts no shadow", "[lab3]") {
    requireShadows();
    const Color lit = unshadowed({above});
    for (const float height : {6.75f, 8.f, 12.f, 40.f}) {
        const Vec3 centre(0, 0, height);
        expectLit(about(centre), seen({above}, {thing(centre)}), lit, beyondLight);
    }
}

TEST_CASE("a room around everything casts no shadow", "[lab3]") {
    requireShadows();
    expectLit("the floor under a light, inside a ball of radius 50 that holds them both",
              seen({above}, {Sphere({0, 0, 0}, 50, matte({1, 1, 1}))}), unshadowed({above}),
              beyondLight);
}

TEST_CASE("what stands beside the way to a light casts no shadow", "[lab3]") {
    requireShadows();
    const Color lit = unshadowed({above});
    for (const Vec3& centre : {Vec3(1, 0, 3), Vec3(0, 0.75f, 5), Vec3(3, 0, 1), Vec3(0, -2, 2)})
        expectLit(
            about(centre), seen({above}, {thing(centre)}), lit,
            "the shadow ray goes from the hit point to the light: does it go elsewhere here?");
}

TEST_CASE("what stands behind the surface casts no shadow", "[lab3]") {
    requireShadows();
    const Color lit = unshadowed({above});
    for (const Vec3& centre : {Vec3(0, 0, -3), Vec3(0, 0, -0.75f), Vec3(0, 0, -6)})
        expectLit(
            about(centre), seen({above}, {thing(centre)}), lit,
            "the shadow ray has to start at the surface and go to the light: not the other way, "
            "and not from beyond");
}

TEST_CASE("a shadow moves with its light", "[lab3]") {
    requireShadows();
    const Light slanted({4, 0, 6});
    const Color lit = unshadowed({slanted});
    expectBlack("the floor's point (0, 0, 0) under a light at (4, 0, 6), with a ball at (2, 0, 3)",
                seen({slanted}, {thing({2, 0, 3})}),
                "is the shadow ray sent to this light's place?");
    expectLit("the floor's point (0, 0, 0) under a light at (4, 0, 6), with a ball at (0, 0, 3)",
              seen({slanted}, {thing({0, 0, 3})}), lit,
              "is the shadow ray sent to this light's place?");
}

TEST_CASE("glass and mirrors cast shadows like anything else", "[lab3]") {
    requireShadows();
    for (const Material& material : {Material({1, 1, 1}, 0.2f, 0.8f, 1.3f), Material({1, 1, 1}, 1)})
        expectBlack("a floor under a light, with a ball of glass or a mirror ball between them",
                    seen({above}, {Sphere({0, 0, 3}, 0.5f, material)}),
                    "the shadow of this lab asks whether something stands in the way, not of what "
                    "it is made");
}

TEST_CASE("each light has its own shadow", "[lab3]") {
    requireShadows();
    const Light red({0, 0, 6}, {1, 0, 0}), green({4, 0, 6}, {0, 1, 0});
    const Color redAlone = unshadowed({red}), greenAlone = unshadowed({green});
    const auto expectOnly = [](const std::vector<Light>& lights, const Vec3& centre,
                               const Color& expected) {
        const Color got = seen(lights, {thing(centre)});
        if (same(got, expected)) return;
        fail({"a floor under a light in shadow and another one that nothing hides",
              "the colour " + lab::text(got), lab::text(expected) + ", as of the other light alone",
              isBlack(got) ? "the shadow of one light darkens the other as well: in shadow of "
                             "one, go on with the next"
              : isBlack(seen({above}, {thing({0, 0, 3})}))
                  ? "every light needs a shadow ray of its own"
                  : tooShort});
    };
    for (const auto& lights : {std::vector{red, green}, std::vector{green, red}}) {
        expectOnly(lights, {0, 0, 3}, greenAlone);
        expectOnly(lights, {2, 0, 3}, redAlone);
    }
}

TEST_CASE("there are shadows at every depth of recursion", "[lab3]") {
    requireShadows();
    for (const int depth : {0, 1, 5})
        expectBlack("a ball between floor and light, seen by traceRay() with depth " +
                        std::to_string(depth),
                    seen({above}, {thing({0, 0, 3})}, depth),
                    "depth limits reflected and refracted rays alone: a shadow ray is needed at "
                    "every depth");
}
