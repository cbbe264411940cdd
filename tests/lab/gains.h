#pragma once

#include "lab/stage.h"

/// What a surface shows of its scattered light and of what another ray brings.
namespace lab {

/// One case of a surface, and all that its colour comes from.
struct Mix {
    float w;
    sw::Color scattered, brought;
    sw::Color got;
    float other = 0;  ///< weight of the other task's ray: 0 if that task is right, or not done
    sw::Color otherBrought;

    sw::Color right() const {
        return (1 - w - other) * scattered + w * brought + other * otherBrought;
    }
    bool isRight() const { return agree(got, right()); }
};

/// How much of what the other task's ray sees gets into the colour.
inline float otherWeight(const Gain& gain, float w) {
    Painted stage{gain, w};
    const sw::Color dark = stage.seen();
    stage.otherDark = false;
    const float weight = (stage.seen() - dark)[0] / sky[0];
    return std::isfinite(weight) && std::fabs(weight) > 1e-4f ? weight : 0;
}

/// True if nothing of another task gets into a picture without lights: black is black, and this
/// task's ray is the only one that is followed.
inline bool isUndisturbed(const Gain& gain) {
    const bool black = Painted{gain, 0, false, true, {0, 0, 0}}.seen().isZero();
    return black && otherWeight(gain, 0.5f) == 0;
}

inline Mix mixOf(const Gain& gain, float w, bool lit, int depth = 4) {
    Painted stage{gain, 0, lit, true, paint, depth};
    Mix mix{w, stage.seen(), sky, {}, otherWeight(gain, w), {}};
    mix.otherBrought = stage.behind();
    stage.weight = w;
    mix.got = stage.seen();
    return mix;
}

/// Light shows more, but a surface that shows no number in it (task 1) shows nothing of this task.
inline bool lightHelps(const Gain& gain) {
    return isNumber(Painted{gain, 0, true}.seen());
}

inline std::vector<Mix> mixes(const Gain& gain) {
    std::vector<Mix> all;
    for (const float w : {1.f, 0.9f, 0.75f, 0.6f, 0.4f, 0.25f, 0.1f}) {
        all.push_back(mixOf(gain, w, false));
        if (lightHelps(gain)) all.push_back(mixOf(gain, w, true));
    }
    return all;
}

/// Mistakes with the loss of the scattered light, or with both weights.
inline std::vector<Suspect<Mix>> lossSuspects(const Gain& gain) {
    const std::string lost =
        "what the surface scatters is lost: it keeps all but the part " + gain.part;
    const std::string gone = gain.mirrored ? "that is mirrored" : "that gets through";
    return {
        {[](const Mix& m) { return m.scattered + m.w * m.brought; },
         "the weights add up to more than 1: light " + gone +
             " cannot be scattered as well, so what a surface scatters has to get less by the "
             "part " +
             gain.part},
        {[](const Mix& m) { return m.scattered + m.brought; },
         "the two colours are added without their weights, which add up to 1"},
        {[](const Mix& m) { return m.w * m.scattered + (1 - m.w) * m.brought; },
         "the two weights are the wrong way round: the greater the " + gain.weight +
             ", the more of the " + gain.light + " and the less of the scattered light arrives"},
        {[](const Mix& m) { return m.w * (m.scattered + m.brought); },
         "the scattered light has the weight of the " + gain.light +
             " one: its own is the rest of 1"},
        {[](const Mix& m) { return (1 - m.w) * (1 - m.w) * m.scattered + m.w * m.brought; },
         "the scattered light is weakened twice"},
        {[](const Mix& m) { return m.brought; }, lost},
        {[](const Mix& m) { return m.w * m.brought; }, lost},
        {[](const Mix& m) { return (1 - glassIndex) * m.scattered + glassIndex * m.brought; },
         "the refractive index is taken for the transparency: the index bends rays, the "
         "transparency tells how much light gets through"},
    };
}

/// Mistakes with what the ray brings.
inline std::vector<Suspect<Mix>> gainSuspects(const Gain& gain) {
    const std::string color = "the " + gain.light + " colour ", nothing = nothingHint(gain);
    return {
        {[](const Mix& m) { return m.scattered; }, nothing},
        {[](const Mix& m) { return (1 - m.w) * m.scattered; }, nothing},
        {[](const Mix& m) { return (1 - m.w) * m.scattered + m.brought; },
         color + "is added without its weight, the " + gain.weight},
        {[](const Mix& m) { return (1 - m.w) * (m.scattered + m.brought); },
         color + "has the weight of the scattered light: its own is the " + gain.weight},
        {[](const Mix& m) { return (1 - m.w) * (m.scattered + m.w * m.brought); },
         color + "was weakened too: only what the surface scatters gets less by the part " +
             gain.part},
        {[](const Mix& m) { return (1 - m.w) * m.scattered + m.w * m.w * m.brought; },
         "the " + gain.weight + " is multiplied in twice"},
        {[](const Mix& m) { return (1 - m.w) * m.scattered + 2 * m.w * m.brought; },
         color + "is added twice"},
        {[](const Mix& m) { return (1 - m.w) * m.scattered + m.w * paint.times(m.brought); },
         "the surface's colour belongs to the scattered light alone: what the " + gain.light +
             " ray brings keeps its own colour"},
        {[](const Mix& m) { return (1 - m.w) * m.scattered + m.w * paint; },
         "the surface's own colour is added where the colour that the " + gain.light +
             " ray brings is due"},
    };
}

/// Why surfaces show the wrong share of what this task's ray brings; empty if they do not, or if no
/// mistake explains all that comes out.
inline std::string weightHint(const Gain& gain) {
    const std::vector<Mix> cases = mixes(gain);
    const auto isRight = [](const Mix& m) { return m.isRight(); };
    if (std::all_of(cases.begin(), cases.end(), isRight)) return "";
    if (isTraced(gain) && !followsRightly(gain)) return wrongRayHint(gain, *followed(gain));
    std::vector<Suspect<Mix>> suspects = lossSuspects(gain);
    for (const Suspect<Mix>& suspect : gainSuspects(gain)) suspects.push_back(suspect);
    const auto* mistake = culprit(
        cases, [](const Mix& m) { return m.got; }, suspects);
    return mistake == nullptr ? "" : mistake->hint;
}

/// A fault of a colour that came out, unless what went in has it already.
inline std::string newFault(const sw::Color& got, const sw::Color& before) {
    return faultOfColor(before).empty() ? faultOfColor(got) : "";
}

/// The same for one of the cases.
inline std::string hintFor(const Gain& gain, const Mix& mix) {
    const std::string fault = newFault(mix.got, mix.scattered);
    return fault.empty() ? weightHint(gain) : fault;
}

}  // namespace lab
