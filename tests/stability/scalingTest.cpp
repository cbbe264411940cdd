// A scene scaled by a power of two is the same scene: floats and doubles scale exactly, and nothing
// in the library is an absolute length. So decisions are the same and positions scale to the bit.

#include "stability/randomScenes.h"
#include "stability/scaledNff.h"
#include "swImage.h"
#include "swNff.h"
#include "swSampling.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

struct Pair {
    Scene original, scaled;
    float factor;
};

Pair anyPair(Random& random) {
    Pair pair;
    pair.factor = std::ldexp(1.0f, random.whole(-20, 20));
    for (int i = random.whole(2, 30); i > 0; --i) {
        Sphere sphere = anySphere(random);
        Triangle triangle = anyTriangle(random);
        if (random.coin()) sphere = Sphere({0, 0, 0}, 30, sphere.material);  // all around
        pair.original.push(sphere);
        pair.original.push(triangle);
        sphere.center *= pair.factor;
        sphere.radius *= pair.factor;
        for (Vec3& v : triangle.vertices) v *= pair.factor;
        pair.scaled.push(sphere);
        pair.scaled.push(triangle);
    }
    return pair;
}

// Follows one path through both scenes, with a shadow ray from every hit.
std::string follow(Random& random, const Pair& pair) {
    Ray ray(random.point(10), random.direction()), twin(ray.orig * pair.factor, ray.dir);
    for (int bounce = 0; bounce < 10; ++bounce) {
        Intersection hit, twinHit, blocker;
        const bool found = pair.original.intersect(ray, hit);
        if (pair.scaled.intersect(twin, twinHit) != found) return describe("hit", bounce, ray);
        if (!found) break;
        if (!isSame(hit.position * pair.factor, twinHit.position)) return describe("position", ray);
        if (hit.hitT * pair.factor != twinHit.hitT) return describe("t", ray);
        if (!isSame(hit.normal, twinHit.normal) || hit.frontFacing != twinHit.frontFacing)
            return describe("normal", ray);
        const Vec3 light = random.point(10);
        const bool shadow = pair.original.intersect(hit.getShadowRay(light), blocker, true);
        const Ray twinShadow = twinHit.getShadowRay(light * pair.factor);
        if (pair.scaled.intersect(twinShadow, blocker, true) != shadow)
            return describe("shadow", bounce, ray, "light", light);
        const bool mirror = random.coin();
        ray = mirror ? hit.getReflectedRay() : hit.getRefractedRay();
        twin = mirror ? twinHit.getReflectedRay() : twinHit.getRefractedRay();
        if (!isSame(ray.orig * pair.factor, twin.orig) || !isSame(ray.dir, twin.dir))
            return describe(mirror ? "reflected" : "refracted", ray, twin);
    }
    return "";
}

// The picture of the lab scene with all of its lengths scaled.
Image render(float factor) {
    constexpr int side = 96;
    NffScene lab = parseNff(scaledNff(SW_SCENES "/cornell.nff", factor), "scaled");
    lab.camera.setup(side, side);
    Image image(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            seedPixel(1, x, y);
            image.at(x, y) = lab::samplePixel(static_cast<float>(x), static_cast<float>(y), 3, 5,
                                              lab.camera, lab.scene);
        }
    }
    return image;
}

}  // namespace

TEST_CASE("scaling a scene by a power of two changes no decision") {
    checkRandomCases(familySize, [](Random& random) {
        const Pair pair = anyPair(random);
        const std::string problem = follow(random, pair);
        return problem.empty() ? problem : describe("factor", pair.factor) + problem;
    });
}

TEST_CASE("the lab scene looks the same at every scale") {
    const Image original = render(1);
    CHECK(original.at(3, 48)[0] > original.at(3, 48)[1]);  // the red wall
    for (const float factor : {0x1p-20f, 0x1p-10f, 0x1p10f, 0x1p20f}) {
        const Image scaled = render(factor);
        int different = 0;
        for (int y = 0; y < original.height(); ++y)
            for (int x = 0; x < original.width(); ++x)
                if (!isSame(original.at(x, y), scaled.at(x, y))) ++different;
        CAPTURE(factor);
        CHECK(different == 0);
    }
}
