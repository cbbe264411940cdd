#include "lab/ballPicture.h"
#include "lab/depths.h"

using namespace lab;
using namespace sw;

// traceRay() and glass: what it adds, and which rays it follows.

namespace {

void expectThroughGlass(float t) {
    const Mix mix = mixOf(refraction, t, false);
    if (mix.isRight()) return;
    fail({"glass of transparency " + text(t) + " and index 1.3 before a sky of colour " + text(sky),
          text(mix.got), text(mix.right()), hintFor(refraction, mix)});
}

}  // namespace

TEST_CASE("perfect glass shows the sky behind it", "[lab5]") {
    expectThroughGlass(1);
}

TEST_CASE("glass weakens what it shows by its transparency", "[lab5]") {
    for (const float t : {0.1f, 0.25f, 0.6f, 0.9f}) expectThroughGlass(t);
}

namespace {

// Panes under a black lid, which is all that a mirrored ray finds.
World panesUnderLid(int count, const Material& material) {
    World world = panes(count, material);
    world.scene.push(std::make_shared<DarkPane>(100.f, -1.f));
    return world;
}

std::string panesHint(int k, const Color& got, const Color& unlit, World& world) {
    if (!newFault(got, unlit).empty()) return faultOfColor(got);
    if (const std::string hint = weightHint(refraction); !hint.empty()) return hint;
    const bool first = k > 1 && goesOnToAnother(world);
    if (first && agree(got, 0.25f * unlit + 0.75f * sky))
        return "only one of the panes counts, and behind it the sky shows: behind glass there may "
               "be glass";
    if (first && agree(got, unlit))
        return "the recursion ends at the second pane, as if it were opaque, although the "
               "depth allows more";
    return "";
}

}  // namespace

TEST_CASE("light that gets through k panes is weakened k times", "[lab5]") {
    const Color unlit = panesUnderLid(1, glass(0, glassIndex)).colorOf(fromEye, 9);
    Color expected = 0.25f * unlit + 0.75f * sky;
    for (const int k : {2, 3, 4}) {
        expected = 0.25f * unlit + 0.75f * expected;
        World world = panesUnderLid(k, glass(0.75f, glassIndex));
        const Color got = world.colorOf(fromEye, 9);
        if (agree(got, expected)) continue;
        fail({std::to_string(k) + " panes of transparency 0.75 before a sky of colour " + text(sky),
              text(got), text(expected), panesHint(k, got, unlit, world)});
    }
}

namespace {

const Ray intoWater(Vec3(-40, 0, 30), Vec3(0.8f, 0, -0.6f));

// Why something else shows in the water than what lies in the refracted direction.
std::string directionHint(const std::vector<Ray>& rays) {
    if (!isTraced(refraction)) return nothingHint(refraction);
    const Vec3 followed = rays.back().dir;
    if (!isNumber(followed)) return faultOf(followed);
    Intersection hit;
    Pane(0, 1, glass(1, 4 / 3.f)).intersect(intoWater, hit);
    const Ray own = hit.getRefractedRay();
    const Crossing crossing{intoWater.dir, hit.normal, 4 / 3.f, true};
    if (agree(followed, own.dir))
        return agree(heading(followed), crossing.refracted())
                   ? startHint(own, hit, -hit.normal, "refracted")
                   : bendHint(own, crossing);
    if (agree(heading(followed), intoWater.dir))
        return "the ray that traceRay() follows is the one that came in: follow the refracted one";
    if (agree(followed, hit.getReflectedRay().dir))
        return "the ray that traceRay() follows is the mirrored one: follow the refracted one";
    return "";
}

}  // namespace

TEST_CASE("a ball under water is seen where the bent ray goes", "[lab5]") {
    // Water of index 4/3: the sine 0.8 of the ray becomes 0.6.
    const std::pair<Vec3, std::string> cases[] = {
        {{60, 0, -80}, "where the refracted ray goes"},
        {{80, 0, -60}, "where the ray would go without water"},
        {{80, 0, 60}, "where the ray would go if the water were a mirror"}};
    const bool whole = isUndisturbed(refraction);
    for (const auto& [centre, where] : cases) {
        World world;
        world.push(Sphere(centre, 10, opaque()));
        const Color black =
            whole ? world.colorOf({{0, 200, 0}, centre - Vec3(0, 200, 0)}, 4) : Color(0, 0, 0);
        world.push(Pane(0, 1, glass(1, 4 / 3.f)));
        const Color expected = where == cases[0].second ? black : sky;
        const Color got =
            whole ? world.colorOf(intoWater, 4) : follow(refraction, world, intoWater, 4);
        if (agree(got, expected)) continue;
        const std::string fault = newFault(got, black), weights = weightHint(refraction);
        fail({"clear water and a black ball " + where, text(got), text(expected),
              !fault.empty()     ? fault
              : !weights.empty() ? weights
                                 : directionHint(world.rays())});
    }
}

TEST_CASE("no refracted ray is traced where nothing is transparent", "[lab5]") {
    const auto countDown = [](float t) {
        World world = panes(1, glass(t, glassIndex));
        world.colorOf(fromEye, 3);
        int sum = -1;  // without the one from the eye
        for (const Ray& ray : world.rays()) sum += ray.dir[2] < 0 && !isEmpty(ray);
        return sum;
    };
    if (const int wasted = countDown(0); wasted > 0) {
        const std::string weights = weightHint(refraction);
        fail({"a surface of transparency 0 and index 1.3",
              std::to_string(wasted) + " refracted ray", "no refracted ray",
              !weights.empty()
                  ? weights
                  : "what has no weight changes no picture but takes its time: when all surfaces "
                    "send on rays that count for nothing, their number multiplies with every step "
                    "of depth"});
    }
    const int useful = countDown(0.01f);
    if (useful == 1) return;
    fail({"a surface of transparency 0.01", std::to_string(useful) + " refracted rays", "one",
          !isTraced(refraction)             ? nothingHint(refraction)
          : useful == 0 && !refractsAtAll() ? refractionNotYet
                                            : ""});
}
