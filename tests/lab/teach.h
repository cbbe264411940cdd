#pragma once

#include <string>

#include "catch.h"
#include "swImage.h"
#include "swRay.h"
#include "swScene.h"

/// Checks that teach: what a failing one says leads a student from the mistake to the idea.
namespace lab {

/// What a failing check says, each in a line or two.
struct Lesson {
    std::string tried;     ///< what was asked of the student's code: "a ray that ..."
    std::string got;       ///< what came out
    std::string expected;  ///< what should have come out
    /// Towards the idea, not the code: one sentence about this mistake. Empty unless what came out
    /// is what that mistake yields: a wrong diagnosis is worse than none.
    std::string hint;
};

/// Fails the running test case with this lesson.
[[noreturn]] void fail(const Lesson& lesson);

/// Numbers and vectors in a lesson, with few digits: "0.25", "(1, -0.5, 0)".
std::string text(float number);
std::string text(const sw::Vec3& v);

/// What a value must never be: "NaN, which is no number: ...", likewise for infinite ones, and for
/// colours negative ones. Empty where it is nothing of that kind.
std::string faultOf(const sw::Vec3& v);
std::string faultOfColor(const sw::Color& color);

/// What there is to say where the pictures below differ.
struct PictureLesson {
    std::string tried;  ///< "a sphere under one light"
    std::string hint;
};

/// Compares a picture with pictures/<name>.ppm, as shown on the screen in 8 bits. Both, and their
/// difference made visible, go into the lab report, right or wrong.
/// @param tolerance  largest difference of a channel that is all right, in steps of 8 bits
/// @param strays     so many pixels may differ by more: edges where rounding decides
void expectPicture(const std::string& name, const sw::Image& picture, int tolerance, int strays,
                   const PictureLesson& lesson);

/// Is hit by nothing, but sees and counts every ray that a scene is asked about. Push it into a
/// scene. Ends a recursion that knows no end: from the `limit`-th ray on it throws TooManyRays.
class RayWitness : public sw::Primitive {
public:
    explicit RayWitness(int limit) : most(limit) {}
    bool intersect(const sw::Ray& ray, sw::Intersection&) const override;

    mutable std::vector<sw::Ray> rays;

private:
    int most;
};

/// Thrown through the student's traceRay().
struct TooManyRays {};

}  // namespace lab
