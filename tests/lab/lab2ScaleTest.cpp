#include <cmath>

#include "lab/triangleQuestions.h"

using namespace lab;
using namespace sw;

namespace {

// Whether a hit has t, position and normal as they should be.
bool isRecordRight(const Asked& asked, const Intersection& hit, const Vec3& normal, float size) {
    return std::fabs(hit.hitT - asked.t) <= 1e-3f && isNear(hit.normal, normal, 1e-3f) &&
           isNear(hit.position, at(asked.shape, asked.place), 1e-4f * size);
}

struct Answer {
    bool found = false, isRight = false;
    Intersection hit;
};

Answer answerTo(const Asked& asked, const Vec3& normal, float size) {
    Answer answer;
    answer.found = asked.shape.intersect(asked.ray, answer.hit);
    answer.isRight = answer.found == shouldHit(asked) &&
                     (!answer.found || isRecordRight(asked, answer.hit, normal, size));
    return answer;
}

std::string text(const Answer& answer) {
    const Intersection& hit = answer.hit;
    return answer.found ? "a hit at t = " + lab::text(hit.hitT) + ", position " +
                              lab::text(hit.position) + ", normal " + lab::text(hit.normal)
                        : "no hit";
}

// What is right at its own size should be so `factor` times as large; what is wrong there already,
// the other tests judge.
void expectSame(const TriangleCase& sample, const Asked& ordinary, const Vec3& normal,
                float factor) {
    const Asked asked = scaled(ordinary, factor);
    const Answer answer = answerTo(asked, normal, factor * sample.size);
    if (answer.isRight || !answerTo(ordinary, normal, sample.size).isRight) return;
    const bool due = shouldHit(ordinary);
    const std::string fault = answer.found ? faultOfHit(answer.hit) : "";
    fail({text(asked), text(answer),
          due ? "a hit at t = " + lab::text(asked.t) + ", position " +
                    lab::text(at(asked.shape, asked.place)) + ", normal " + lab::text(normal)
              : "no hit",
          !fault.empty()        ? fault
          : answer.found == due ? absoluteEpsilon
                                : whyWrong(asked)});
}

// Powers of 2, so that floats lose nothing.
void expectSameAtSize(float factor) {
    requireHits();
    for (const TriangleCase& sample : triangleCases())
        for (const Barycentric& place :
             {Barycentric{0.25f, 0.25f}, Barycentric{0.125f, 0.75f}, Barycentric{0.75f, 0.125f},
              Barycentric{-0.25f, 0.5f}, Barycentric{0.5f, -0.25f}, Barycentric{0.75f, 0.5f},
              Barycentric{-3, 5}, Barycentric{20, 0.25f}})
            for (const float height : {2.f, -0.75f})
                for (const float slant : {0.f, 1.f}) {
                    const Vec3 away =
                        sample.size * (height * sample.normal + slant * sample.across);
                    expectSame(sample, askedTo(sample.shape, place, away),
                               height > 0 ? sample.normal : -sample.normal, factor);
                }
}

}  // namespace

TEST_CASE("a small triangle is hit as one of ordinary size", "[lab2]") {
    expectSameAtSize(0x1p-11f);
}

TEST_CASE("a large triangle is hit as one of ordinary size", "[lab2]") {
    expectSameAtSize(0x1p8f);
}
