#include "lab/ballPicture.h"

using namespace lab;
using namespace sw;

// Mirrors among lights, and among other surfaces. How bright the lights make a surface is not asked
// here: the same surface is compared with itself.

namespace {

void expectLit(float r) {
    const Mix mix = mixOf(reflection, r, lightHelps(reflection));
    if (mix.isRight()) return;
    fail({"a lit surface of reflectivity " + text(r) + " that mirrors a sky of colour " +
              text(sky) + "; with reflectivity 0 it is " + text(mix.scattered),
          text(mix.got), text(mix.right()), hintFor(reflection, mix)});
}

}  // namespace

TEST_CASE("scattered and mirrored light together weigh 1", "[lab4]") {
    for (const float r : {1.f, 0.75f, 0.25f}) expectLit(r);
}

namespace {

const Ray slanting(Vec3(-50, 0, 50), unit(Vec3(1, 0, -1)));

// Is met by that ray, not by those that go on from it or from the hiding pane.
class SlantedMirror : public Pane {
public:
    using Pane::Pane;
    bool intersect(const Ray& ray, Intersection& hit) const override {
        return ray.dir[0] > 0.1f && Pane::intersect(ray, hit);
    }
};

// A mirror that shows the sky; a pane hides the light from it. Both are of the same material: which
// of their records is looked at later, as mistakes in task 3 may mix them up, makes no difference.
Color mirrorInShadow(float r, bool withLight) {
    World world;
    world.scene.push(std::make_shared<SlantedMirror>(0.f, 1.f, opaque(r, paint)));
    world.push(Pane(50, -1, opaque(r, paint), 10));
    if (withLight) world.push(Light(Vec3(0, 0, 100), Color(1, 1, 1)));
    return world.colorOf(slanting, 4);
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

bool mirrorsUnlit(float r) {
    return agree(mirrorInShadow(r, false), (1 - r) * mirrorInShadow(0, false) + r * sky);
}

std::string shadowHint(float r, const Color& got, const Color& scattered) {
    if (const std::string hint = weightHint(reflection); !hint.empty()) return hint;
    if (!newFault(got, scattered).empty()) return faultOfColor(got);
    const std::string rest = "a shadow takes one light's scattered light away and nothing else";
    if (!mirrorsUnlit(r)) return "";
    if (got.isZero())
        return "black is returned in the shadow before the mirror has its turn: " + rest;
    if (agree(got, scattered)) return "in the shadow nothing is mirrored: " + rest;
    return "";
}

}  // namespace

TEST_CASE("a mirror in the shadow still mirrors", "[lab4]") {
    for (const float r : {1.f, 0.6f}) {
        if (!isUndisturbed(reflection)) return expectLit(r);
        const Color scattered = mirrorInShadow(0, true);
        if (!isNumber(scattered)) continue;  // shading is not asked about
        const Color got = mirrorInShadow(r, true);
        const Color expected = (1 - r) * scattered + r * sky;
        if (agree(got, expected) || (mirrorsUnlit(r) && !shadowsAreRight())) continue;
        fail({"a surface of reflectivity " + text(r) + " in the shadow; without lights it is " +
                  text(mirrorInShadow(r, false)),
              text(got), text(expected), shadowHint(r, got, scattered)});
    }
}

namespace {

// A painted mirror in front of a pane of painted glass, which mirrors as well, and a light between
// them. What the mirror shows is a surface with another record.
struct Pair {
    float r = 0.6f;
    float glassR = 0.15f, glassT = 0.35f;
    bool lit = false;

    World build() const {
        World world;
        world.push(Pane(0, 1, opaque(r, paint), 50));
        const Material material({0.3f, 0.6f, 0.8f}, glassR, glassT, glassIndex);
        world.scene.push(std::make_shared<FarPane>(100.f, -1.f, material));
        if (lit) world.push(Light(Vec3(0, 0, 50), Color(1, 1, 1)));
        return world;
    }
    Color seen(const Ray& ray) const { return build().colorOf(ray, 6); }
};

// The mirrored ray, as the student's code makes it; empty if there is none.
Ray mirroredRay() {
    World world = Pair{}.build();
    world.colorOf(slanting, 6);
    for (const Ray& ray : world.rays())
        if (ray.dir[2] > 0) return {ray.orig, ray.dir, ray.minT};
    return {};
}

// The colours that come out if the record of the mirror's hit has turned into that of the glass by
// the time that some part of the formula is calculated.
bool isSharedRecord(const Color& got, const Pair& pair, const Color& scattered,
                    const Color& shown) {
    const Color glassScattered = Pair{0, 0, 0, pair.lit}.seen(mirroredRay());
    for (const Color& s : {scattered, glassScattered})
        for (const float loss : {pair.r, pair.glassR})
            for (const float gain : {pair.r, pair.glassR})
                for (const float lossT : {0.f, pair.glassT})
                    for (const float gainT : {0.f, pair.glassT})
                        if (agree(got, (1 - loss - lossT) * s + gain * shown + gainT * sky))
                            return true;
    return false;
}

}  // namespace

TEST_CASE("a mirror stays what it is while its mirrored ray is followed", "[lab4]") {
    if (!isUndisturbed(reflection)) return expectLit(0.6f);
    Pair pair;
    pair.r = 0, pair.lit = true;
    Color scattered = pair.seen(slanting);
    const Ray ray = mirroredRay();
    Color shown = isEmpty(ray) ? sky : pair.seen(ray);
    if (!isNumber(scattered) || !isNumber(shown)) {
        pair.lit = false;
        scattered = pair.seen(slanting), shown = isEmpty(ray) ? sky : pair.seen(ray);
    }
    pair.r = 0.6f;
    const Color got = pair.seen(slanting), expected = (1 - pair.r) * scattered + pair.r * shown;
    if (agree(got, expected)) return;
    std::string hint = newFault(got, scattered + shown);
    if (hint.empty()) hint = isEmpty(ray) ? nothingHint(reflection) : weightHint(reflection);
    const bool proven = hint.empty() && mixOf(reflection, pair.r, pair.lit).isRight();
    if (proven && isSharedRecord(got, pair, scattered, shown))
        hint =
            "the record of this hit is no longer the same after the recursive call: a static or "
            "global Intersection is shared by all calls of traceRay(), but each needs its own";
    fail({"a surface of reflectivity 0.6 that scatters " + text(scattered) +
              ", and mirrors a pane of glass of colour " + text(shown),
          text(got), text(expected), hint});
}

TEST_CASE("mirror balls among black balls: the picture", "[lab4]") {
    constexpr int mostRays = 20000;
    World world(mostRays);
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
    const Image image = pictureOf(reflection, world);
    const std::string fault = faultOfPicture(image), weights = weightHint(reflection);
    const Suspect<Meeting>* direction = mirrorCulprit();
    expectPicture("lab4-mirrors", image, 3, 20,
                  {"four mirror balls and five black ones under the sky",
                   !fault.empty()         ? fault
                   : !weights.empty()     ? weights
                   : direction != nullptr ? direction->hint
                                          : ""});
}
