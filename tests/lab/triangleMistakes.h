#pragma once

#include <string>

#include "lab/triangles.h"

/// Which mistake of task 2 yields what came out. Every mistake that is known is a model: what it
/// would answer is computed, and compared with what the student's code does answer, for the case
/// that failed and for some thousand others. A hint is given where all of that agrees.
namespace lab {

/// A ray and a triangle, and what is true of them.
struct Asked {
    sw::Triangle shape;
    sw::Ray ray;
    Barycentric place;  ///< of the point where the ray, or the line that it is on, meets the plane
    float t;            ///< of that point
};

/// A ray to that place whose origin is `away` from it.
inline Asked askedTo(const sw::Triangle& shape, const Barycentric& place, const sw::Vec3& away,
                     float t = 1) {
    return {shape, sw::Ray(at(shape, place) + away, away * (-1 / t)), place, t};
}

/// Of a point of the triangle's plane.
Barycentric placeOf(const sw::Triangle& shape, const sw::Vec3& point);

/// Whether the slides call it a hit.
bool shouldHit(const Asked& asked);

/// Triangle and ray, `factor` times as large; t and place stay. Exact for powers of 2.
Asked scaled(const Asked& asked, float factor);

/// A hint where intersect() wrongly returned true, or false; empty where no mistake is known that
/// does this.
std::string whyWrong(const Asked& asked);

/// The same where it rightly returned true, but with another hitT or position.
std::string whyOtherT(const Asked& asked, float hitT);
std::string whyElsewhere(const Asked& asked, const sw::Vec3& position);

/// A hint where intersect() never returns true; else empty.
std::string whyNeverHit();

/// A hint for what is wrong at one size alone: all else in the computation grows by powers of it.
inline constexpr const char* absoluteEpsilon =
    "the same triangle and ray, larger or smaller until the triangle is some 4 to 8 wide, get the "
    "right answer: a fixed number like 0.000001 stands beside numbers that grow with the triangle";

/// Fails the test if the plain triangle is missed from both sides: else it might pass without any
/// work done.
void requireHits();

/// What a hit's hitT and position must never be: see faultOf(). Empty where they are no such thing.
std::string faultOfHit(const sw::Intersection& hit);

}  // namespace lab
