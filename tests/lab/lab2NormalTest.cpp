#include <cmath>

#include "lab/triangleQuestions.h"

using namespace lab;
using namespace sw;

namespace {

std::string whyNotUnit(const Question& q) {
    const Vec3 got = q.hit.normal, n = normalOf(q.sample.shape);
    const float most = 1e-3f * n.norm();
    if (isNear(got, n, most) || isNear(got, -n, most))
        return "a cross product is as long as its parallelogram is large: shading needs the "
               "direction alone";
    const Vec3 tooShort = n * (1 / (n * n));
    if (isNear(got, tooShort, 1e-3f * tooShort.norm()) ||
        isNear(got, -tooShort, 1e-3f * tooShort.norm()))
        return "this normal is n / |n|^2: to have length 1 it is divided by its length once";
    return "";
}

std::string whyOtherDirection(const Question& q, const Vec3& expected) {
    Vec3 got = q.hit.normal;
    got.normalize();
    if (isNear(got, -expected, 1e-3f))
        return "both n and -n stand on the plane: the record wants the one that looks back to "
               "where the ray came from";
    if (!got.isZero() && std::fabs(got * expected) < 1e-3f)
        return "this normal lies in the triangle's plane: it has to stand at a right angle to it";
    return "";
}

bool sameNormal(const Intersection& a, const Intersection& b) {
    return (a.normal - b.normal).isZero();
}

}  // namespace

TEST_CASE("the normal of a hit has length 1", "[lab2]") {
    eachHit([](const Question& q) {
        const float length = q.hit.normal.norm();
        if (std::fabs(length - 1) <= 1e-4f) return;
        q.fail("the normal " + text(q.hit.normal) + ", of length " + text(length), "length 1",
               firstOf({faultOf(q.hit.normal), whyUnset(q.asked, "normal", sameNormal),
                        whyNotUnit(q)}));
    });
}

TEST_CASE("the normal of a hit is on the side that the ray came from", "[lab2]") {
    eachHit([](const Question& q) {
        const Vec3 expected = q.fromFront ? q.sample.normal : -q.sample.normal;
        Vec3 n = q.hit.normal;
        n.normalize();
        if (isNear(n, expected, 1e-3f)) return;
        q.fail("the normal " + text(q.hit.normal), "the direction " + text(expected),
               firstOf({faultOf(q.hit.normal), whyUnset(q.asked, "normal", sameNormal),
                        whyOtherDirection(q, expected)}));
    });
}

namespace {

// What is said of the front, to a ray that comes from the front or from behind.
bool saysFront(const Triangle& t, bool fromFront) {
    const Vec3 n = normalOf(t) * (fromFront ? 1 : -1);
    Intersection hit;
    t.intersect(rayTo(t, {0.25f, 0.25f}, n), hit);
    return hit.frontFacing;
}

std::string whyWrongSide(const Question& q) {
    const bool front = saysFront(q.sample.shape, true), behind = saysFront(q.sample.shape, false);
    if (front == behind)
        return "frontFacing is the same from both sides: a normal turned to the ray looks back to "
               "it from either, so only n = e1 x e2 itself tells them apart";
    return behind ? "frontFacing is the wrong way round: n = e1 x e2 looks out of the front, and a "
                    "ray that comes from there runs against it"
                  : "";
}

}  // namespace

TEST_CASE("the front is where the vertices run counter-clockwise", "[lab2]") {
    eachHit([](const Question& q) {
        if (q.hit.frontFacing == q.fromFront) return;
        const auto same = [](const auto& a, const auto& b) {
            return a.frontFacing == b.frontFacing;
        };
        q.fail(std::string("from ") + (q.fromFront ? "the front" : "behind") + ", frontFacing is " +
                   (q.hit.frontFacing ? "true" : "false"),
               q.fromFront ? "true" : "false",
               firstOf({whyUnset(q.asked, "frontFacing", same), whyWrongSide(q)}));
    });
}
