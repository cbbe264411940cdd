#include "swBounds.h"

#include "support.h"
#include "swSphere.h"
#include "swTriangle.h"

using namespace sw;
using namespace test;

namespace {

bool encloses(const Bounds& box, const dvec3& p) {
    for (int i = 0; i < 3; ++i)
        if (!(box.min[i] <= p[i] && p[i] <= box.max[i])) return false;
    return true;
}

bool encloses(const Bounds& box, const Vec3& p) {
    return encloses(box, toDouble(p));
}

bool isSameBox(const Bounds& a, const Bounds& b) {
    return isSame(a.min, b.min) && isSame(a.max, b.max);
}

// Says nothing about its extent, as a first try of a student's own.
class Unmeasured : public Primitive {
public:
    bool intersect(const Ray&, Intersection&) const override { return false; }
};

}  // namespace

TEST_CASE("a new box holds nothing") {
    const Bounds box;
    CHECK_FALSE(box.isFinite());
    CHECK_FALSE(encloses(box, Vec3(0, 0, 0)));
}

TEST_CASE("a box that holds one point is finite and as small as the point") {
    Bounds box;
    box.add(Vec3(1, -2, 3));
    CHECK(box.isFinite());
    CHECK(distance(box.min, Vec3(1, -2, 3)) == 0);
    CHECK(distance(box.max, Vec3(1, -2, 3)) == 0);
}

TEST_CASE("a box is just large enough for the points added to it") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    Bounds box;
    dvec3 lowest(HUGE_VAL), highest(-HUGE_VAL);
    for (int i = random.whole(1, 20); i > 0; --i) {
        const Vec3 p = random.point(10);
        box.add(p);
        lowest = min(lowest, toDouble(p));
        highest = max(highest, toDouble(p));
    }
    CHECK(box.isFinite());
    CHECK(distance(box.min, lowest) == 0);
    CHECK(distance(box.max, highest) == 0);
}

TEST_CASE("adding a box is adding its corners") {
    Bounds box({-1, 0, 1}, {1, 2, 3}), fresh;
    box.add(Bounds({-5, 1, 0}, {0, 9, 2}));
    CHECK(isSameBox(box, Bounds({-5, 0, 0}, {1, 9, 3})));
    fresh.add(box);
    CHECK(isSameBox(fresh, box));
}

TEST_CASE("adding an empty box changes nothing") {
    Bounds box({-1, 0, 1}, {1, 2, 3}), fresh;
    box.add(Bounds());
    CHECK(isSameBox(box, Bounds({-1, 0, 1}, {1, 2, 3})));
    fresh.add(Bounds());
    CHECK(isSameBox(fresh, Bounds()));
}

TEST_CASE("a coordinate that is NaN changes nothing in a box") {
    Bounds box({-1, -1, -1}, {1, 1, 1});
    box.add(Vec3(NAN, 0, NAN));
    CHECK(isSameBox(box, Bounds({-1, -1, -1}, {1, 1, 1})));
    box.add(Vec3(2, NAN, -3));
    CHECK(isSameBox(box, Bounds({-1, -1, -3}, {2, 1, 1})));
}

TEST_CASE("a box is finite only with an end on every side") {
    CHECK(Bounds({-1, -1, -1}, {1, 1, 1}).isFinite());
    CHECK(Bounds({-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}).isFinite());
    CHECK_FALSE(Bounds::unbounded().isFinite());
    for (int i = 0; i < 3; ++i) {
        const Bounds cube({-1, -1, -1}, {1, 1, 1});
        Bounds below = cube, above = cube, undefined = cube, turned = cube;
        below.min[i] = -HUGE_VALF;
        above.max[i] = HUGE_VALF;
        undefined.min[i] = NAN;
        turned.min[i] = 2;
        CHECK_FALSE(below.isFinite());
        CHECK_FALSE(above.isFinite());
        CHECK_FALSE(undefined.isFinite());
        CHECK_FALSE(turned.isFinite());
    }
}

TEST_CASE("the unbounded box holds every point") {
    CHECK(encloses(Bounds::unbounded(), Vec3(FLT_MAX, -FLT_MAX, 0)));
    Bounds box({-1, -1, -1}, {1, 1, 1});
    box.add(Bounds::unbounded());
    CHECK(isSameBox(box, Bounds::unbounded()));
}

TEST_CASE("a primitive that does not know its box is unbounded") {
    CHECK(isSameBox(Unmeasured().bounds(), Bounds::unbounded()));
}

TEST_CASE("the box of a sphere holds it closely") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const Sphere sphere{random.point(100), random.magnitude(1e-3, 1e3), {}};
    const Bounds box = sphere.bounds();
    const dvec3 centre = toDouble(sphere.center), extent(sphere.radius);
    CHECK(box.isFinite());
    CHECK(encloses(box, centre - extent));
    CHECK(encloses(box, centre + extent));
    const double slack = 4 * u * (num::maxAbs(sphere.center) + sphere.radius);
    CHECK(distance(box.min, centre - extent) <= slack);
    CHECK(distance(box.max, centre + extent) <= slack);

    Intersection hit;
    REQUIRE(sphere.intersect(Ray(sphere.center, random.direction()), hit));
    CHECK(encloses(box, hit.position));
}

TEST_CASE("the box of a triangle ends at its vertices") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const Vec3 v[] = {random.point(10), random.point(10), random.point(10)};
    const Bounds box = Triangle(v, {}).bounds();
    const dvec3 a = toDouble(v[0]), b = toDouble(v[1]), c = toDouble(v[2]);
    CHECK(box.isFinite());
    CHECK(distance(box.min, min(a, min(b, c))) == 0);
    CHECK(distance(box.max, max(a, max(b, c))) == 0);
}

TEST_CASE("a flat triangle has a flat and finite box") {
    const Vec3 v[] = {{0, 2, 0}, {4, 2, 0}, {0, 2, 4}};
    const Bounds box = Triangle(v, {}).bounds();
    CHECK(box.isFinite());
    CHECK(isSameBox(box, Bounds({0, 2, 0}, {4, 2, 4})));
}
