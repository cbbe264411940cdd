#include "lab/gains.h"

using namespace lab;
using namespace sw;

// traceRay() and mirrors: what it adds, and which rays it follows.

namespace {

// Falls onto the middle of a mirror at z = 0, and would be mirrored to the right.
const Ray slanting(Vec3(-50, 0, 50), unit(Vec3(1, 0, -1)));

void expectInMirror(float r) {
    const Mix mix = mixOf(reflection, r, false);
    if (mix.isRight()) return;
    fail({"a mirror of reflectivity " + text(r) + " under a sky of colour " + text(sky),
          text(mix.got), text(mix.right()), hintFor(reflection, mix)});
}

}  // namespace

TEST_CASE("a perfect mirror shows the sky", "[lab4]") {
    expectInMirror(1);
}

TEST_CASE("a mirror weakens what it shows by its reflectivity", "[lab4]") {
    for (const float r : {0.1f, 0.25f, 0.6f, 0.9f}) expectInMirror(r);
}

namespace {

// Why something else shows in a mirror than what lies in the mirrored direction.
std::string directionHint(const std::vector<Ray>& rays) {
    if (rays.size() < 2) return nothingHint(reflection);
    const Vec3 followed = rays[1].dir, in = slanting.dir;
    if (!isNumber(followed)) return faultOf(followed);
    Intersection hit;
    Pane(0, 1, opaque(1)).intersect(slanting, hit);
    const Ray own = hit.getReflectedRay();
    const Meeting meeting{in, hit.normal};
    if (!agree(followed, own.dir))
        return agree(heading(followed), in) ? "the ray that traceRay() follows is the one that "
                                              "came in: follow the mirrored one"
                                            : "the ray that traceRay() follows is not the one that "
                                              "getReflectedRay() returns";
    if (!agree(heading(followed), meeting.mirrored())) return mirrorHint(own, meeting);
    return startHint(own, hit, hit.normal, "mirrored");
}

}  // namespace

TEST_CASE("a mirror shows what lies in the mirrored direction", "[lab4]") {
    const std::pair<Vec3, std::string> cases[] = {{{50, 0, 50}, "where the mirrored ray goes"},
                                                  {{50, 0, -50}, "behind the mirror, straight on"},
                                                  {{0, 0, 50}, "straight above the mirror"},
                                                  {{-50, 50, 50}, "beside the eye"}};
    for (const auto& [centre, where] : cases) {
        World world;
        world.push(Sphere(centre, 10, opaque()));
        const Color black = world.colorOf({{0, 0, 200}, centre - Vec3(0, 0, 200)}, 4);
        world.push(Pane(0, 1, opaque(1)));
        const Color expected = where == cases[0].second ? black : sky;
        if (!isUndisturbed(reflection)) return expectInMirror(1);
        const Color got = world.colorOf(slanting, 4);
        if (agree(got, expected)) continue;
        const std::string fault = newFault(got, black), weights = weightHint(reflection);
        fail({"a perfect mirror and a black ball " + where, text(got), text(expected),
              !fault.empty()     ? fault
              : !weights.empty() ? weights
                                 : directionHint(world.rays())});
    }
}

namespace {

// Up and down between a floor and a ceiling that end after k mirrored points.
World zigzag(int k, float r) {
    World world;
    const float end = 10 * (static_cast<float>(k) - 0.5f);
    world.push(Pane(0, 1, opaque(r), end));
    world.push(Pane(10, -1, opaque(r), end));
    return world;
}

std::string zigzagHint(int k, const Color& got, const Color& unlit, World& world) {
    if (!newFault(got, unlit).empty()) return faultOfColor(got);
    if (const std::string hint = weightHint(reflection); !hint.empty()) return hint;
    const bool first = k > 1 && goesOnToAnother(world);
    if (first && agree(got, 0.5f * (unlit + sky)))
        return "only one of the mirrors counts, and behind it the sky shows: what a mirror shows "
               "may be a mirror again";
    if (first && agree(got, 0.5f * (unlit + unlit)))
        return "the recursion ends at the second mirror, as if it were none, although the "
               "depth allows more";
    return "";
}

}  // namespace

TEST_CASE("light that is mirrored k times is weakened k times", "[lab4]") {
    if (!isUndisturbed(reflection)) return expectInMirror(0.5f);
    const Ray first(Vec3(-5, 0, 5), unit(Vec3(1, 0, -1)));
    const Color unlit = zigzag(1, 0).colorOf(first, 9);
    Color expected = sky;
    for (const int k : {1, 2, 3, 4}) {
        expected = 0.5f * (unlit + expected);
        World world = zigzag(k, 0.5f);
        const Color got = world.colorOf(first, 9);
        if (agree(got, expected)) continue;
        fail({"a ray that meets mirrors of reflectivity 0.5 " + std::to_string(k) +
                  " times before it reaches the sky of colour " + text(sky),
              text(got), text(expected), zigzagHint(k, got, unlit, world)});
    }
}

TEST_CASE("no mirrored ray is traced where nothing is reflective", "[lab4]") {
    const auto countUpwards = [](float r) {
        World world;
        world.push(Pane(0, 1, opaque(r)));
        world.colorOf(fromEye, 3);
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
    const bool empty = isStarters(Meeting{{0, 0, -1}, {0, 0, 1}}.asked());
    fail({"a surface of reflectivity 0.01", std::to_string(useful) + " mirrored rays", "one",
          !isTraced(reflection)  ? nothingHint(reflection)
          : useful == 0 && empty ? reflectionNotYet
                                 : ""});
}
