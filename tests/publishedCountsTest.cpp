#include "lab.h"
#include "scenes.h"
#include "support.h"
#include "swNff.h"
#include "swRenderer.h"

using namespace sw;

// Eric Haines' documentation of the Standard Procedural Databases says how many rays any classical
// ray tracer casts for its scenes, "within about 10 %": at 512 x 512 pixels with rays through their
// corners, and trees of rays five levels high.

namespace {

RayCount raysOf(const std::string& text) {
    NffScene file = parseNff(text, "generated");
    file.camera.setup(512, 512);
    Image image(512, 512);
    const auto corner = [&](int x, int y) {
        return traceRay(file.camera.getRay(static_cast<float>(x), static_cast<float>(y)),
                        file.scene, 4);
    };
    return renderCorners(image, {0, 0, 512, 512}, corner).rays;
}

struct Published {
    double eyeHits, reflected, refracted, shadow;
};

void check(double count, double published) {
    CAPTURE(count, published);
    CHECK(std::fabs(count - published) <= 0.1 * published);
}

// The published counts contain shadow rays of no weight, which we leave out.
void check(const RayCount& rays, const Published& published) {
    CHECK(rays[RayKind::primary] == 513 * 513);
    check(static_cast<double>(rays.primaryHits), published.eyeHits);
    check(static_cast<double>(rays[RayKind::reflected]), published.reflected);
    check(static_cast<double>(rays[RayKind::refracted]), published.refracted);
    check(static_cast<double>(rays[RayKind::shadow] + rays[LeftOut::shadowZeroWeight]),
          published.shadow);
}

}  // namespace

TEST_CASE("balls cost as many rays as published") {
    check(raysOf(scenes::balls(4)), {263169, 175095, 0, 954368});
}

TEST_CASE("tetra costs as many rays as published") {
    check(raysOf(scenes::tetra(6)), {49788, 0, 0, 46112});
}

TEST_CASE("mount costs as many rays as published") {
    check(raysOf(scenes::mount(6)), {173125, 354769, 354769, 412922});
}
