#pragma once

#include <limits>

#include "lab/samplePlaces.h"

/// What the student's samplePixel() makes of its samples, and which mistake makes that.
namespace lab {

/// A pixel under an even sky: every sample brings the same.
struct EvenPixel {
    int n;
    Pixel pixel;
    sw::Color expected;
};

inline EvenPixel evenPixel(int n, const sw::Color& color) {
    sw::seedPixel(9, n, 0);
    const sw::Scene scene = skyScene(color);
    const sw::Ray ray = frontCamera().getRay(1.5f, 1.5f);
    return {n, pixelOf(scene, 1, 1, n), traceRay(ray, scene, 3)};
}

inline const std::vector<EvenPixel>& evenPixels() {
    static const std::vector<EvenPixel> all = [] {
        std::vector<EvenPixel> some;
        for (const int n : {2, 3, 4, 5, 8}) some.push_back(evenPixel(n, sky));
        return some;
    }();
    return all;
}

/// What should come out, or what comes out of a mistake.
inline bool isAlike(const sw::Color& got, const sw::Color& wanted) {
    const float size = std::max({1.f, wanted[0], wanted[1], wanted[2]});
    return alike(got, wanted, 1e-3f * size);
}

inline bool keepsColour(const EvenPixel& even) {
    return isAlike(even.pixel.color, even.expected);
}

/// Whether all pixels have this color(even).
template <typename Colour>
bool allShow(Colour color) {
    return std::all_of(evenPixels().begin(), evenPixels().end(), [&](const EvenPixel& even) {
        return isAlike(even.pixel.color, color(even));
    });
}

/// A number that the sum of n * n samples is divided by, in place of n * n.
struct Divisor {
    float (*of)(float n);
    const char* text;
};

inline std::string divisorHint() {
    const std::initializer_list<Divisor> divisors{{[](float n) { return n; }, "n"},
                                                  {[](float n) { return 2 * n; }, "n + n"},
                                                  {[](float n) { return n + 1; }, "n + 1"},
                                                  {[](float n) { return n * n + 1; }, "n * n + 1"},
                                                  {[](float n) { return n * n - 1; }, "n * n - 1"},
                                                  {[](float n) { return n * n * n; }, "n * n * n"}};
    for (const Divisor& divisor : divisors)
        if (allShow([&](const EvenPixel& even) {
                const float n = static_cast<float>(even.n);
                return n * n / divisor.of(n) * even.expected;
            }))
            return std::string(
                       "the colour is as if the sum of the n * n samples were divided by ") +
                   divisor.text + " in place of their number";
    const EvenPixel& first = evenPixels()[0];
    const float n = static_cast<float>(first.n);
    const float constant = std::round(n * n * first.expected[0] / first.pixel.color[0]);
    if (allShow([&](const EvenPixel& even) {
            return static_cast<float>(even.n * even.n) / constant * even.expected;
        }))
        return "the colour is as if the sum were divided by " + text(constant) +
               " whatever n is: there are n * n samples";
    return "";
}

/// A colour in whole steps; rounded: 0.5, or 0 where the rest is cut off.
inline sw::Color inSteps(const sw::Color& color, float steps, float rounded) {
    sw::Color result;
    for (int i = 0; i < 3; ++i) result.m[i] = std::floor(color[i] * steps + rounded) / steps;
    return result;
}

/// Black may come from a factor of 0: infinitely bright samples make NaN of that. For n = 1 the
/// whole number 1 / (n * n) is 1. Or from whole numbers that count up what is below 1.
inline std::string blackHint() {
    const float infinite = std::numeric_limits<float>::infinity();
    const sw::Color blinding = evenPixel(3, sw::Color(infinite, infinite, infinite)).pixel.color;
    if (std::isnan(blinding[0]) && keepsColour(evenPixel(1, sky)))
        return "black: 1 divided by a whole number is 0, as whole numbers know no fractions, and "
               "0 times the sum is 0";
    const EvenPixel bright = evenPixel(3, sw::Color(3.7f, 2.6f, 1.4f));
    if (isAlike(bright.pixel.color, inSteps(bright.expected, 1, 0)))
        return "black: the colours are counted in whole numbers, which cut off all that is below "
               "1";
    if (bright.pixel.color.isZero())
        return "black: nothing of what the samples bring reaches the colour that is returned";
    return "";
}

inline std::string bytesHint() {
    for (const float steps : {255.f, 256.f})
        for (const float rounded : {0.f, 0.5f})
            if (allShow(
                    [&](const EvenPixel& even) { return inSteps(even.expected, steps, rounded); }))
                return "the colours are counted in whole steps, as of a byte, which lose the rest: "
                       "numbers of type float keep it";
    return "";
}

/// The known mistake that explains the colours under an even sky; empty if there is none, and
/// where all is well.
inline std::string evenHint() {
    const auto& all = evenPixels();
    if (std::all_of(all.begin(), all.end(), keepsColour)) return "";
    for (const EvenPixel& even : all)
        if (const std::string fault = faultOfColor(even.pixel.color); !fault.empty()) return fault;
    if (!allFew([](const Samples& samples) { return !wrongCount(samples); })) return "";
    const auto timesSky = [](float (*factor)(float n)) {
        return allShow([&](const EvenPixel& even) {
            return factor(static_cast<float>(even.n)) * even.expected;
        });
    };
    if (timesSky([](float) { return 0.f; })) return blackHint();
    if (timesSky([](float n) { return n * n; }))
        return "this is the sum of all samples: a pixel shows their mean";
    if (timesSky([](float n) { return 1 / (n * n); }))
        return "this is an n * n-th of the mean: all samples are added up, and their sum is "
               "divided "
               "once";
    if (timesSky([](float n) { return 1 - std::exp2(-n * n); }))
        return "each sample takes half the place of all before it: in a mean all weigh the same";
    const std::string hint = divisorHint();
    return hint.empty() ? bytesHint() : hint;
}

}  // namespace lab
