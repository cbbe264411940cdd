#include <string>
#include <vector>

#include "lab/lambertMistakes.h"
#include "lab/spot.h"
#include "lab/teach.h"

using namespace sw;
using lab::Spot;

namespace {

const Color paint = Spot().color;

// What is no colour at all is called by its name; a known mistake, if it is one, comes behind.
std::string hintFor(const Spot& spot, const Color& got) {
    std::string hint = lab::faultOfColor(got);
    const std::string mistake = lab::lambertHint(spot);
    if (!hint.empty() && !mistake.empty()) hint += "; ";
    return hint += mistake;
}

void expectColor(const std::string& tried, const Spot& spot, const Color& expected) {
    const Color got = lab::colorOf(spot);
    if (lab::sameColor(got, expected)) return;
    lab::fail({tried, "the colour " + lab::text(got), lab::text(expected), hintFor(spot, got)});
}

std::string lightAt(const Vec3& fromSurface) {
    return "a surface that faces +z, with a white light at " + lab::text(fromSurface) + " from it";
}

}  // namespace

TEST_CASE("a surface is lit by the cosine of the angle to the light", "[lab1]") {
    struct Case {
        Vec3 light;
        float cosine;
    };
    for (const Case& c : {Case{{0, 0, 2}, 1}, Case{{3, 0, 4}, 0.8f}, Case{{0, -4, 3}, 0.6f},
                          Case{{1, 2, 2}, 2 / 3.f}, Case{{12, 0, 5}, 5 / 13.f},
                          Case{{-24, 0, 7}, 0.28f}, Case{{0, 60, 11}, 11 / 61.f}})
        expectColor(lightAt(c.light), {{Light(c.light)}}, paint * c.cosine);
}

TEST_CASE("a light behind the surface gives nothing", "[lab1]") {
    for (const Vec3& light : {Vec3(3, 0, -4), Vec3(0, 0, -2), Vec3(24, 0, -7)})
        expectColor(lightAt(light), {{Light(light)}}, Color(0, 0, 0));
}

TEST_CASE("a light behind the surface takes nothing from the light in front", "[lab1]") {
    const Light front({3, 0, 4}), behind({4, 0, -3});
    for (const auto& lights : {std::vector{front, behind}, std::vector{behind, front}})
        expectColor(
            "a surface between two white lights, its normal at cosine 0.8 to one and -0.6 "
            "to the other",
            {lights}, paint * 0.8f);
}

TEST_CASE("a light far away is as bright as one nearby", "[lab1]") {
    for (const float times : {1.f, 0.125f, 2.f, 64.f, 1024.f}) {
        const Vec3 light = Vec3(3, 0, 4) * times;
        expectColor(lightAt(light), {{Light(light)}}, paint * 0.8f);
    }
}

TEST_CASE("a matt surface looks the same from everywhere", "[lab1]") {
    for (const Vec3& toEye : {Vec3(0, 0, 5), Vec3(-5, 0, 12), Vec3(24, 0, 7)})
        expectColor("a surface that faces +z, a light at (3, 0, 4) and the eye at " +
                        lab::text(toEye) + " from it",
                    {{Light({3, 0, 4})}, paint, Spot().where, toEye}, paint * 0.8f);
}

TEST_CASE("moving surface, light and eye together changes nothing", "[lab1]") {
    for (const Vec3& where : {Vec3(-3, 8, 1), Vec3(-3, 0, 0), Vec3(6, 12, 0)})
        expectColor("a surface that faces +z at " + lab::text(where) + ", a white light at " +
                        lab::text(where + Vec3(3, 0, 4)),
                    {{Light({3, 0, 4})}, paint, where}, paint * 0.8f);
}

TEST_CASE("a surface answers in its own colour", "[lab1]") {
    for (const Color& color : {Color(1, 0, 0), Color(0, 0.5f, 1), Color(0.25f, 0.75f, 0.5f)})
        expectColor(
            "a surface of colour " + lab::text(color) + " under a white light at a cosine of 0.8",
            {{Light({3, 0, 4})}, color}, color * 0.8f);
}

TEST_CASE("a coloured light tints what it shines on", "[lab1]") {
    struct Case {
        Color tint, expected;
    };
    for (const Case& c : {Case{{1, 0, 0}, {0.4f, 0, 0}}, Case{{0.5f, 1, 2}, {0.2f, 0.2f, 1.2f}},
                          Case{{0, 0.5f, 0}, {0, 0.1f, 0}}})
        expectColor("a surface of colour " + lab::text(paint) + " under a light of colour " +
                        lab::text(c.tint) + " at a cosine of 0.8",
                    {{Light({3, 0, 4}, c.tint)}}, c.expected);
}

TEST_CASE("several lights add up", "[lab1]") {
    const Light red({3, 0, 4}, Color(1, 0, 0));
    const Light green({0, 4, 3}, Color(0, 0.5f, 0));
    const Light blue({-24, 0, 7}, Color(0, 0, 1));
    expectColor("a surface of colour " + lab::text(paint) +
                    " under a red, a green and a blue light, from different directions",
                {{red, green, blue}}, Color(0.4f, 0.075f, 0.21f));
}
