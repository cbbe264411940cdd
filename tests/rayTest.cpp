#include "swRay.h"

#include <cmath>

#include "support.h"
#include "swIntersection.h"

using namespace sw;
using namespace test;

TEST_CASE("a ray holds t between its limits, without these, and never NaN", "[ray]") {
    const Ray ray(Vec3(1, 2, 3), Vec3(0, 0, 2), 1, 4);
    CHECK(ray.contains(2));
    CHECK(ray.contains(std::nextafter(1.f, 2.f)));
    CHECK_FALSE(ray.contains(1));
    CHECK_FALSE(ray.contains(4));
    CHECK_FALSE(ray.contains(NAN));
    CHECK_FALSE(Ray(ray.orig, ray.dir, 0, NAN).contains(2));
    CHECK_FALSE(Ray(ray.orig, ray.dir, NAN).contains(2));
}

TEST_CASE("t counts in units of the ray's direction", "[ray]") {
    const Vec3 point = Ray(Vec3(1, 2, 3), Vec3(0, -1, 2)).at(1.5f);
    CHECK((point[0] == 1 && point[1] == 0.5f && point[2] == 6));
}

TEST_CASE("a hit's normal is on the ray's side, whichever side is the front", "[intersection]") {
    const auto [fromOutside, insideOut] =
        GENERATE(table<bool, bool>({{true, false}, {false, false}, {true, true}, {false, true}}));
    Intersection hit;
    hit.setFace(Vec3(0, 1, 0), fromOutside, insideOut);
    CHECK(hit.normal[1] == (fromOutside ? 1 : -1));
    CHECK(hit.frontFacing == (fromOutside != insideOut));
}
