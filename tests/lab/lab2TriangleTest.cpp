#include <cmath>

#include "lab/triangleQuestions.h"

using namespace lab;
using namespace sw;

namespace {

// The hitT should be the question's t.
void expectT(const Asked& asked, const Intersection& hit, float most) {
    if (std::fabs(hit.hitT - asked.t) <= most) return;
    const auto same = [](const auto& a, const auto& b) { return a.hitT == b.hitT; };
    fail({text(asked), "a hit at t = " + text(hit.hitT), "a hit at t = " + text(asked.t),
          firstOf({faultOf(Vec3(hit.hitT, 0, 0)), whyUnset(asked, "hitT", same),
                   whyOtherT(asked, hit.hitT)})});
}

}  // namespace

TEST_CASE("a ray through the inside of a triangle hits it", "[lab2]") {
    eachHit([](const Question&) {});
}

// Numbers that floats round.
TEST_CASE("a triangle has no holes", "[lab2]") {
    for (const Triangle& shape :
         {triangle({-1.1f, -2.3f, 0.7f}, {3.2f, -1.9f, 2.4f}, {0.6f, 3.1f, -1.3f}),
          triangle({31.7f, 20.3f, -41.1f}, {-22.9f, 11.3f, -35.7f}, {13.1f, -33.7f, -19.9f})})
        for (float w = 0.03f; w < 0.95f; w += 0.0313f)
            for (float v = 0.03f; w + v < 0.97f; v += 0.0371f)
                for (const float slant : {0.f, 0.37f, -0.61f}) {
                    Vec3 n = normalOf(shape);
                    n.normalize();
                    const Vec3 away = n * (3 * slant + 1.3f) + slant * side(shape, 1);
                    const Asked asked = askedTo(shape, {w, v}, away, 0.7f);
                    if (!isHit(shape, asked.ray))
                        fail({text(asked), "no hit", "a hit where " + text(asked.place),
                              whyWrong(asked)});
                }
}

TEST_CASE("t counts in units of the ray's direction", "[lab2]") {
    for (const float length : {1.f, 2.f, 0.5f, 8.f}) {
        const Asked asked{
            plainTriangle(), Ray({1, 1, 4}, {0, 0, -length}), {0.25f, 0.25f}, 4 / length};
        Intersection hit;
        if (!asked.shape.intersect(asked.ray, hit))
            fail({text(asked), "no hit", "a hit at t = " + text(asked.t), whyWrong(asked)});
        expectT(asked, hit, 1e-4f);
    }
    eachHit([](const Question& q) { expectT(q.asked, q.hit, 1e-3f); });
}

TEST_CASE("a hit says where it is", "[lab2]") {
    eachHit([](const Question& q) {
        const Vec3 expected = at(q.sample.shape, q.asked.place), got = q.hit.position;
        if (isNear(got, expected, 1e-4f * q.sample.size)) return;
        const auto same = [](const auto& a, const auto& b) {
            return (a.position - b.position).isZero();
        };
        q.fail("the position " + text(got), text(expected),
               firstOf({faultOf(got), whyUnset(q.asked, "position", same),
                        whyElsewhere(q.asked, got)}));
    });
}

TEST_CASE("a hit carries the triangle's material", "[lab2]") {
    eachHit([](const Question& q) {
        const Material &got = q.hit.material, &expected = q.sample.shape.material;
        const bool color = (got.color - expected.color).isZero();
        if (color && got.reflectivity == expected.reflectivity &&
            got.transparency == expected.transparency &&
            got.refractiveIndex == expected.refractiveIndex)
            return;
        const auto same = [](const auto& a, const auto& b) {
            return (a.material.color - b.material.color).isZero();
        };
        q.fail("a material of colour " + text(got.color) + ", reflectivity " +
                   text(got.reflectivity) + ", transparency " + text(got.transparency),
               "the triangle's, " + text(expected.color) + ", " + text(expected.reflectivity) +
                   ", " + text(expected.transparency),
               color ? "the colour is the triangle's, but the rest of its material is not"
                     : whyUnset(q.asked, "material", same));
    });
}

TEST_CASE("a hit carries the ray", "[lab2]") {
    eachHit([](const Question& q) {
        const Ray &got = q.hit.ray, &expected = q.asked.ray;
        if ((got.orig - expected.orig).isZero() && (got.dir - expected.dir).isZero()) return;
        const auto same = [](const auto& a, const auto& b) {
            return (a.ray.orig - b.ray.orig).isZero() && (a.ray.dir - b.ray.dir).isZero();
        };
        const bool unit = isNear(got.dir, Vec3(expected.dir).normalize(), 1e-5f);
        q.fail("the record holds " + text(got), "the same ray",
               unit ? "the direction in the record's ray has been made 1 long: the record wants "
                      "the ray as it was asked"
                    : whyUnset(q.asked, "ray", same));
    });
}
