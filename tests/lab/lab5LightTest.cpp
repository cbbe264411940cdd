#include "lab/gains.h"

using namespace lab;
using namespace sw;

// Glass that also scatters or mirrors. How bright is not asked here: the same surface is compared
// with itself.

TEST_CASE("scattered and refracted light together weigh 1", "[lab5]") {
    for (const float t : {1.f, 0.75f, 0.25f}) {
        const Mix mix = mixOf(refraction, t, lightHelps(refraction));
        if (mix.isRight()) continue;
        fail({"a lit surface of transparency " + text(t) + " before a sky of colour " + text(sky) +
                  "; with transparency 0 it is " + text(mix.scattered),
              text(mix.got), text(mix.right()), hintFor(refraction, mix)});
    }
}

namespace {

// Glass without lights that mirrors as well. What either of the rays sees may be black.
struct Shares {
    float r, t;
    bool aboveDark = false, belowDark = false;

    Color got() const {
        World world;
        world.scene.push(
            std::make_shared<FarPane>(0.f, 1.f, Material(Color(0, 0, 0), r, t, glassIndex)));
        if (aboveDark) world.scene.push(std::make_shared<DarkPane>(100.f, -1.f));
        if (belowDark) world.scene.push(std::make_shared<DarkPane>(-100.f, 1.f));
        return world.colorOf(fromEye, 4);
    }
    Color above() const { return aboveDark ? scattered() : sky; }
    Color below() const { return belowDark ? scattered() : sky; }
    // What the surface shows without the one part, or the other.
    Color mirrored() const { return Shares{r, 0, aboveDark, belowDark}.got(); }
    Color refracted() const { return Shares{0, t, aboveDark, belowDark}.got(); }
    Color scattered() const { return Shares{0, 0}.got(); }
    // As far as it is this task's affair: what task 4 does with glass of reflectivity 0 is not.
    Color right() const { return mirrored() + refracted() - scattered(); }
};

std::vector<Suspect<Shares>> sharesSuspects() {
    return {
        {[](const Shares& s) { return (1 - s.t) * s.mirrored() + s.t * s.below(); },
         "the mirrored light was weakened as well: what gets through is missing from the scattered "
         "light alone, as reflectivity, transparency and the rest add up to 1"},
        {[](const Shares& s) { return (1 - s.r) * s.refracted() + s.r * s.above(); },
         "the refracted light was weakened by the part that is mirrored: what is mirrored is "
         "missing from the scattered light alone, as reflectivity, transparency and the rest add "
         "up to 1"},
        {[](const Shares& s) { return s.mirrored(); },
         "nothing is refracted where a surface mirrors as well: each of the two has its own share"},
        {[](const Shares& s) { return s.refracted(); },
         "nothing is mirrored where light gets through as well: each of the two has its own "
         "share"}};
}

}  // namespace

TEST_CASE("what gets through comes on top of what is mirrored", "[lab5]") {
    std::vector<Shares> all;
    for (const auto& [r, t] : {std::pair(0.25f, 0.5f), {0.2f, 0.8f}, {0.5f, 0.1f}})
        for (const auto& [above, below] : {std::pair(false, false), {true, false}, {false, true}})
            all.push_back({r, t, above, below});
    for (const Shares& s : all) {
        if (s.aboveDark || s.belowDark) continue;  // these help to tell mistakes apart
        const Mix alone = mixOf(refraction, s.t, false);
        const bool isRight = agree(s.got(), s.right());
        if (isRight && alone.isRight()) continue;
        const std::vector<Suspect<Shares>> suspects = sharesSuspects();
        const auto* mistake = culprit(
            all, [](const Shares& x) { return x.got(); }, suspects);
        const std::string fault = newFault(s.got(), s.mirrored());
        fail({"glass of reflectivity " + text(s.r) + " and transparency " + text(s.t) +
                  " without lights; with transparency 0 it is " + text(s.mirrored()) +
                  ", and with reflectivity 0 it is " + text(s.refracted()),
              text(s.got()),
              text(isRight ? s.mirrored() + s.t * (s.below() - s.scattered()) : s.right()),
              isRight              ? hintFor(refraction, alone)
              : !fault.empty()     ? fault
              : mistake != nullptr ? mistake->hint
                                   : weightHint(refraction)});
    }
}

namespace {

// The inside of glass, met from afar at a slant at which no light gets out.
class Inside : public FarPane {
public:
    explicit Inside(float t) : FarPane(0, 1, glass(t, 1.5f)) {}
    bool intersect(const Ray& ray, Intersection& hit) const override {
        const bool met = FarPane::intersect(ray, hit);
        hit.frontFacing = false;
        return met;
    }
};

// All directions see the sky.
Color seenFromInside(float t) {
    World world;
    world.scene.push(std::make_shared<Inside>(t));
    return world.colorOf(Ray(Vec3(-80, 0, 60), Vec3(0.8f, 0, -0.6f)), 4);
}

}  // namespace

TEST_CASE("totally reflected light keeps the weight of the transparency", "[lab5]") {
    const Color scattered = seenFromInside(0);
    for (const float t : {1.f, 0.6f, 0.25f}) {
        const float other = otherWeight(refraction, t);
        const Color got = seenFromInside(t);
        const Color expected = (1 - t - other) * scattered + (t + other) * sky;
        if (agree(got, expected)) continue;
        const std::string fault = newFault(got, scattered), weights = weightHint(refraction);
        const bool lost = agree(got, (1 - t) * scattered);
        fail({"glass of transparency " + text(t) +
                  " and index 1.5 that a ray meets from inside so "
                  "much at a slant that no light gets out, under a sky of colour " +
                  text(sky),
              text(got), text(expected),
              !fault.empty()     ? fault
              : !weights.empty() ? weights
              : lost ? "nothing arrives where all light is reflected: its weight is still the "
                       "transparency, and the ray that getRefractedRay() returns brings it"
                     : ""});
    }
}
