#include "support.h"

using namespace sw;
using namespace test;

namespace {

// Fills a vector with coordinates of very different size.
Vec3 ragged(Random& random) {
    Vec3 v = random.direction();
    for (float& x : v.m) x *= random.magnitude(1e-3, 1e3);
    return v;
}

}  // namespace

TEST_CASE("the operators agree with double precision") {
    Random random(GENERATE(range(0u, 200u)));
    const Vec3 a = ragged(random), b = ragged(random);
    const float s = random.real(-10, 10);
    const double size = glm::length(toDouble(a)) * glm::length(toDouble(b));
    CAPTURE(a, b, s);
    CHECK(distance(a % b, glm::cross(toDouble(a), toDouble(b))) <= 4 * u * size);
    CHECK(std::fabs(a * b - glm::dot(toDouble(a), toDouble(b))) <= 4 * u * size);
    for (int i = 0; i < 3; ++i) {
        CHECK((a + b)[i] == a[i] + b[i]);
        CHECK((a - b)[i] == a[i] - b[i]);
        CHECK((-a)[i] == -a[i]);
        CHECK((a * s)[i] == a[i] * s);
        CHECK((s * a)[i] == s * a[i]);
        CHECK(a.times(b)[i] == a[i] * b[i]);
    }
}

TEST_CASE("assigning operators do what the others do") {
    const Vec3 a(1, 2, 3), b(-4, 5, 0.5f);
    Vec3 sum = a, difference = a, product = a;
    sum += b;
    difference -= b;
    product *= 3;
    CHECK(distance(sum, a + b) == 0);
    CHECK(distance(difference, a - b) == 0);
    CHECK(distance(product, a * 3) == 0);
}

TEST_CASE("any kind of number scales a vector") {
    const Vec3 v(1, -2, 4);
    const dvec3 half(0.5, -1, 2), twice(2, -4, 8);
    CHECK(distance(v * 0.5f, half) == 0);
    CHECK(distance(v * 0.5, half) == 0);
    CHECK(distance(0.5 * v, half) == 0);
    CHECK(distance(v / 2, half) == 0);
    CHECK(distance(v / 0.5, twice) == 0);
    CHECK(distance(v * 2, twice) == 0);
    CHECK(distance(2u * v, twice) == 0);
}

TEST_CASE("coordinates can be read by name and written by index") {
    Vec3 v;
    CHECK((v.x() == 0 && v.y() == 0 && v.z() == 0));
    v[0] = 1;
    v.m[1] = 2;
    v[2] = 3;
    CHECK((v.x() == 1 && v.y() == 2 && v.z() == 3));
}

TEST_CASE("norm and normalize neither overflow nor underflow") {
    Random random(GENERATE(range(0u, 2000u)));
    const Vec3 v = random.direction() * random.magnitude(1e-36, 1e37);
    CAPTURE(v);
    const double length = glm::length(toDouble(v));
    CHECK(std::fabs(v.norm() - length) <= u * length);
    Vec3 unit = v;
    CHECK(&unit.normalize() == &unit);
    CHECK(distance(unit, toDouble(v) / length) <= u);
}

TEST_CASE("normalize keeps what has no direction") {
    CHECK(Vec3(0, 0, 0).normalize().norm() == 0);
    CHECK(Vec3(HUGE_VALF, 1, 0).normalize()[0] == HUGE_VALF);
    CHECK(std::isnan(Vec3(NAN, 1, 0).normalize()[0]));
    CHECK(Vec3(NAN, 1, 0).normalize()[1] == 1);
}
