#include "support.h"
#include "swCorners.h"
#include "swNff.h"
#include "tools/common/mainFunctions.h"
#include "tools/common/scenes/scenes.h"

using namespace sw;

// Eric Haines' documentation of the Standard Procedural Databases says how many rays any classical
// ray tracer casts for its scenes, "within about 10 %": at 512 x 512 pixels with rays through their
// corners, and trees of rays five levels high.

namespace {

RayCount raysOf(const std::string& text) {
    NffScene file = parseNff(text, "generated");
    file.camera.setup(512, 512);
    const auto corner = [&](int x, int y) {
        return lab::traceRay(file.camera.getRay(static_cast<float>(x), static_cast<float>(y)),
                             file.scene, 4);
    };
    return renderCorners({0, 0, 512, 512}, corner).rays;
}

struct Published {
    double eyeHits, reflected, refracted, shadow;
};

void check(double count, double published) {
    CAPTURE(count, published);
    CHECK(std::fabs(count - published) <= 0.1 * published);
}

void check(const RayCount& rays, const Published& published) {
    CHECK(rays[RayKind::primary] == 513 * 513);
    check(static_cast<double>(rays.hitsOf(RayKind::primary)), published.eyeHits);
    check(static_cast<double>(rays[RayKind::reflected]), published.reflected);
    check(static_cast<double>(rays[RayKind::refracted]), published.refracted);
    check(static_cast<double>(rays[RayKind::shadow]), published.shadow);
}

}  // namespace

TEST_CASE("balls cost as many rays as published") {
    check(raysOf(scenes::balls(4)), {263169, 175095, 0, 954368});
}

TEST_CASE("tetra costs as many rays as published") {
    check(raysOf(scenes::tetra(6)), {49788, 0, 0, 46112});
}

TEST_CASE("rings cost as many rays as published") {
    check(raysOf(scenes::rings(7)), {263169, 315236, 0, 1085002});
}

TEST_CASE("tree costs as many rays as published") {
    check(raysOf(scenes::tree(11)), {169836, 0, 0, 1097419});
}

TEST_CASE("mount costs as many rays as published") {
    check(raysOf(scenes::mount(6)), {173125, 354769, 354769, 412922});
}
