#pragma once

#include <string>
#include <vector>

#include "lab/spot.h"
#include "lab/teach.h"

/// Which mistake explains the colours of task 1.
namespace lab {

inline bool sameColor(const sw::Color& a, const sw::Color& b) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= 1e-4f * (1 + std::fabs(b[i])))) return false;
    return true;
}

inline float cosineTo(const sw::Vec3& to) {
    return to[2] / to.norm();
}

inline float lambert(const sw::Vec3& toLight) {
    return std::max(0.f, cosineTo(toLight));
}

/// How a program goes through the lights.
enum class Through { all, first, last, mean };

/// A mistake as a formula: what one light brings, and what becomes of several.
struct LambertMistake {
    const char* hint;
    Through through;
    sw::Color (*brings)(const Spot& spot, const sw::Light& light);
};

inline sw::Color colorBy(const LambertMistake& mistake, const Spot& spot) {
    std::vector<sw::Light> lights = spot.lights;
    if (mistake.through == Through::first) lights = {lights.front()};
    if (mistake.through == Through::last) lights = {lights.back()};
    sw::Color sum;
    for (const sw::Light& light : lights) sum += mistake.brings(spot, light);
    return mistake.through == Through::mean ? sum * (1 / static_cast<float>(lights.size())) : sum;
}

inline sw::Color lightOn(const Spot& spot, const sw::Light& light) {
    return spot.color.times(light.color);
}

inline sw::Color rightColor(const Spot& spot, const sw::Light& light) {
    return lambert(light.position) * lightOn(spot, light);
}

/// Of a cosine that is none, or is used wrongly.
inline std::vector<LambertMistake> wrongCosines() {
    using sw::Light, sw::Vec3;
    const char* falls = "the lights of this lab do not get weaker with distance";
    const auto all = Through::all;
    return {
        {"task 1 is not done yet: every surface is still as white as the starter paints it", all,
         [](const Spot&, const Light&) { return sw::Color(1, 1, 1); }},
        {"the result grows with the distance of the light: a dot product is a cosine only where "
         "both vectors have length 1",
         all, [](auto& s, auto& l) { return std::max(0.f, l.position[2]) * lightOn(s, l); }},
        {falls, all, [](auto& s, auto& l) { return rightColor(s, l) * (1 / l.position.norm()); }},
        {falls, all,
         [](auto& s, auto& l) { return rightColor(s, l) * (1 / (l.position * l.position)); }},
        {"a cosine below zero means that the light stands behind the surface: it gives nothing "
         "then, but takes nothing away either",
         all, [](auto& s, auto& l) { return cosineTo(l.position) * lightOn(s, l); }},
        {"the sign of the cosine tells front from back; without it, lights shine through the "
         "surface",
         all, [](auto& s, auto& l) { return std::fabs(cosineTo(l.position)) * lightOn(s, l); }},
        {"the cosine is cut off to a whole number, so that nearly always 0 is left of it", all,
         [](auto& s, auto& l) { return std::floor(lambert(l.position)) * lightOn(s, l); }},
        {"the length of a cross product is a sine: it is 0 where the light stands straight above, "
         "and Lambert's cosine is 1 there",
         all,
         [](auto& s, auto& l) {
             return (Vec3(0, 0, 1) % l.position).norm() / l.position.norm() * lightOn(s, l);
         }},
        {"the surface is as bright however it is turned to the light: Lambert's cosine is missing",
         all, [](auto& s, auto& l) { return lightOn(s, l); }}};
}

/// Of another direction than that from the surface to the light.
inline std::vector<LambertMistake> wrongDirections() {
    const char* wrongWay =
        "the sign is turned round: the way that counts goes from the surface to the light";
    const char* place =
        "the place of the light is no direction yet: where does the way to it begin?";
    const auto all = Through::all;
    return {{wrongWay, all, [](auto& s, auto& l) { return lambert(-l.position) * lightOn(s, l); }},
            {wrongWay, all, [](auto& s, auto& l) { return -cosineTo(l.position) * lightOn(s, l); }},
            {"what counts is the angle between the normal and the way to the light; a matt surface "
             "looks the same from everywhere",
             all, [](auto& s, auto& l) { return cosineTo(s.eye) * lightOn(s, l); }},
            {"the way to the light is measured from the eye: it begins where the light arrives, on "
             "the surface",
             all, [](auto& s, auto& l) { return lambert(l.position - s.eye) * lightOn(s, l); }},
            {place, all,
             [](auto& s, auto& l) { return lambert(s.where + l.position) * lightOn(s, l); }},
            {place, all, [](auto& s, auto& l) {
                 return std::max(0.f, (s.where + l.position)[2]) * lightOn(s, l);
             }}};
}

/// Of the colours, and of several lights.
inline std::vector<LambertMistake> wrongColors() {
    using sw::Color;
    const auto all = Through::all;
    return {
        {"the material has a colour, and the surface returns only that part", all,
         [](auto&, auto& l) { return lambert(l.position) * l.color; }},
        {"the light has a colour too, and the surface can return no other", all,
         [](auto& s, auto& l) { return lambert(l.position) * s.color; }},
        {"neither the material's colour nor the light's plays a part: the surface returns only "
         "what both have",
         all, [](auto&, auto& l) { return lambert(l.position) * Color(1, 1, 1); }},
        {"the result is grey, as * makes one number of two colours: it is the dot product", all,
         [](auto& s, auto& l) {
             return lambert(l.position) * (s.color * l.color) * Color(1, 1, 1);
         }},
        {"% is the cross product, which means nothing for colours: they multiply component by "
         "component",
         all, [](auto& s, auto& l) { return lambert(l.position) * (s.color % l.color); }},
        {"the two colours are added: a surface takes away from the light, so they multiply", all,
         [](auto& s, auto& l) { return lambert(l.position) * (s.color + l.color); }},
        {"only the last light is seen: what the others gave has to be kept and added to",
         Through::last, rightColor},
        {"only the first light is seen: are the others still asked?", Through::first, rightColor},
        {"the lights are averaged: each adds all that it brings, whatever their number",
         Through::mean, rightColor}};
}

/// Spots at which no two of these mistakes look alike.
inline std::vector<Spot> tellingSpots() {
    using sw::Light, sw::Color, sw::Vec3;
    return {{{Light({3, 0, 4})}},
            {{Light({3, 0, -4})}},
            {{Light({0, 0, 2})}},
            {{Light({192, 0, 256})}},
            {{Light({-24, 0, 7}, Color(0.5f, 1, 2))}, {0.25f, 0.75f, 0.5f}},
            {{Light({3, 0, 4}), Light({4, 0, -3})}},
            {{Light({3, 0, 4}, {1, 0, 0}), Light({0, 4, 3}, {0, 0.5f, 0}), Light({1, 2, 2})}},
            {{Light({3, 0, 4})}, {0.5f, 0.25f, 0.75f}, {6, 12, 0}},
            {{Light({0, 4, 3})}, {0.5f, 0.25f, 0.75f}, {-3, 8, 1}, {24, 0, 7}}};
}

template <typename Gives>
bool explainsAll(const std::vector<Spot>& spots, const Gives& gives) {
    for (const Spot& spot : spots)
        if (!sameColor(colorOf(spot), gives(spot))) return false;
    return true;
}

/// Whether the same is added everywhere, even where no light comes: to every colour or in the
/// surface's own, once or for every light.
inline bool explainedByAmbient(const std::vector<Spot>& spots) {
    const Spot unlit{{sw::Light({3, 0, -4})}};
    const sw::Color more = colorOf(unlit);
    for (const bool own : {false, true})
        for (const bool perLight : {false, true})
            if (!more.isZero() && explainsAll(spots, [&](const Spot& spot) {
                    sw::Color color;
                    for (const sw::Light& light : spot.lights) color += rightColor(spot, light);
                    const float lights = static_cast<float>(spot.lights.size());
                    for (int i = 0; i < 3; ++i)
                        color[i] += more[i] * (own ? spot.color[i] / unlit.color[i] : 1) *
                                    (perLight ? lights : 1);
                    return color;
                }))
                return true;
    return false;
}

/// The mistake that explains the colours of all telling spots and of this one; empty if none does.
inline std::string lambertHint(const Spot& spot) {
    std::vector<Spot> spots = tellingSpots();
    spots.push_back(spot);
    for (const auto& mistakes : {wrongCosines(), wrongDirections(), wrongColors()})
        for (const LambertMistake& mistake : mistakes)
            if (explainsAll(spots, [&](const Spot& s) { return colorBy(mistake, s); }))
                return mistake.hint;
    if (explainedByAmbient(spots))
        return "something is added even where no light comes; here such places are black";
    return "";
}

}  // namespace lab
