#pragma once

#include <cmath>
#include <functional>
#include <initializer_list>
#include <utility>

#include "lab/triangleMistakes.h"

/// Hits that should be, and what their records should hold.
namespace lab {

/// Clear of all edges.
inline constexpr Barycentric insides[] = {
    {0.25f, 0.25f}, {0.5f, 0.25f}, {0.125f, 0.75f}, {0.75f, 0.125f}, {0.125f, 0.125f}};

inline std::string text(const Asked& asked) {
    return text(asked.ray) + " to " + text(asked.shape);
}

/// Something asked of a hit that should be.
struct Question {
    const TriangleCase& sample;
    const Asked& asked;
    bool fromFront;
    const sw::Intersection& hit;

    [[noreturn]] void fail(const std::string& got, const std::string& expected,
                           const std::string& hint) const {
        lab::fail({text(asked), got, expected, hint});
    }
};

/// Rays at a right angle and slanted, from both sides. A miss fails the test.
inline void eachHit(const std::function<void(const Question&)>& check) {
    for (const TriangleCase& sample : triangleCases())
        for (const Barycentric& place : insides)
            for (const auto& [height, t] :
                 {std::pair(2.f, 1.f), {-2.f, 0.5f}, {0.75f, 4.f}, {-0.75f, 2.f}})
                for (const float slant : {0.f, 1.f, -0.5f}) {
                    const sw::Vec3 away =
                        sample.size * (height * sample.normal + slant * sample.across);
                    const Asked asked = askedTo(sample.shape, place, away, t);
                    sw::Intersection hit;
                    if (!sample.shape.intersect(asked.ray, hit))
                        fail({text(asked), "no hit",
                              "a hit at t = " + text(t) + ", where " + text(place),
                              whyWrong(asked)});
                    check({sample, asked, height > 0, hit});
                }
}

/// Two records that have nothing in common.
inline sw::Intersection filled(bool other) {
    sw::Intersection hit;
    hit.hitT = other ? 1e30f : 2e30f;
    hit.position = other ? sw::Vec3(-71, 32, 53) : sw::Vec3(64, -25, 86);
    hit.normal = other ? sw::Vec3(0, 0.25f, 0) : sw::Vec3(0.5f, 0, 0);
    hit.frontFacing = other;
    hit.material = sw::Material(other ? sw::Color(0.75f, 0, 0) : sw::Color(0, 0.875f, 0));
    hit.ray = other ? sw::Ray({9, 8, 7}, {3, 0, 0}) : sw::Ray({-9, 8, 7}, {0, 3, 0});
    return hit;
}

/// A hint where something in the record stays as it was, whatever that is; else empty.
/// @param same  whether it is the same in two records
template <typename Same>
std::string whyUnset(const Asked& asked, const char* field, const Same& same) {
    for (const bool other : {false, true}) {
        sw::Intersection hit = filled(other);
        if (!asked.shape.intersect(asked.ray, hit) || !same(hit, filled(other))) return "";
    }
    return std::string("the record's ") + field + " is left as it was: a hit has to set it";
}

inline std::string firstOf(const std::initializer_list<std::string>& hints) {
    for (const std::string& hint : hints)
        if (!hint.empty()) return hint;
    return "";
}

}  // namespace lab
