#pragma once

#include "lab/nextRay.h"

/// What getRefractedRay() makes of directions, right or wrong.
namespace lab {

/// A ray of unit direction d that meets glass; n: the unit normal on the side that it comes from.
struct Crossing {
    sw::Vec3 d, n;
    float index;
    bool entering;

    float eta() const { return entering ? 1 / index : index; }
    float cosine() const { return d * n; }
    float c() const { return cFor(eta(), cosine()); }
    sw::Vec3 mirrored() const { return d - 2 * cosine() * n; }
    sw::Vec3 refracted() const { return formula(eta(), cosine(), c(), -1); }

    static float cFor(float eta, float cosine) { return 1 - eta * eta * (1 - cosine * cosine); }
    /// Snell's law by the handout, with each part as a mistake may have it. NaN where c < 0.
    sw::Vec3 formula(float eta, float cosine, float c, float sign) const {
        return eta * d + sign * (eta * cosine + std::sqrt(c)) * n;
    }
    sw::Vec3 withEta(float e) const { return formula(e, cosine(), cFor(e, cosine()), -1); }
    sw::Ray asked(float length = 1) const {
        return hitBy(length * d, n, glass(1, index), entering).getRefractedRay();
    }
};

/// Generic ones, in which c is positive with the right eta and with the inverse one.
inline std::vector<Crossing> crossings() {
    std::vector<Crossing> all;
    test::Random random(6);
    for (const float index : {1.25f, 1.5f, 2.f})
        for (const float sine : {0.2f, 0.45f})
            for (const bool entering : {true, false}) {
                const sw::Vec3 n = random.direction();
                all.push_back(
                    {sine * along(n, random) - std::sqrt(1 - sine * sine) * n, n, index, entering});
            }
    return all;
}

inline std::string invertedHint(bool entering) {
    return entering ? "on the way in the two indices have changed places: into the denser body a "
                      "ray bends towards the normal, so its sine gets smaller"
                    : "on the way out the two indices change places: frontFacing is false here, "
                      "the ray goes from the glass into the air and bends away from the normal";
}

using BendSuspect = Suspect<Crossing>;

/// Mistakes with eta or with the way that is taken.
inline std::vector<BendSuspect> waySuspects() {
    return {
        {[](const Crossing& x) { return x.withEta(x.index); }, invertedHint(true)},
        {[](const Crossing& x) { return x.withEta(1 / x.index); }, invertedHint(false)},
        {[](const Crossing& x) { return x.withEta(1 / x.eta()); },
         "on both ways the two indices have changed places: eta is 1 / index where the ray enters, "
         "and index where it leaves"},
        {[](const Crossing& x) { return x.withEta(x.eta() * x.eta()); },
         "the index is multiplied in twice: eta is 1 / index on the way in and index on the way "
         "out"},
        {[](const Crossing& x) { return x.d; }, "the ray goes straight on, as if in air"},
        {[](const Crossing& x) { return x.mirrored(); },
         "the ray is mirrored, but this one gets through: all light is reflected only where no "
         "angle fulfils Snell's law"},
        {[](const Crossing& x) { return x.entering ? x.refracted() : x.d; },
         "on the way out the ray goes straight on: Snell's law holds there as well"},
        {[](const Crossing& x) { return x.entering ? x.d : x.refracted(); },
         "on the way in the ray goes straight on: Snell's law holds there as well"},
        {[](const Crossing& x) { return -x.refracted(); },
         "every sign is the wrong way round: this is where the refracted ray would come from, not "
         "where it goes"},
        {[](const Crossing& x) { return -x.n; },
         "the ray goes on along the normal, wherever it came from: its part along the surface is "
         "lost"},
    };
}

/// Mistakes in c.
inline std::vector<BendSuspect> rootSuspects() {
    const std::string cosine = "the cosine is not squared in c: sin(a)^2 is 1 - cos(a)^2";
    const auto withC = [](float (*c)(float eta, float cosine)) {
        return [c](const Crossing& x) {
            return x.formula(x.eta(), x.cosine(), c(x.eta(), x.cosine()), -1);
        };
    };
    return {
        {withC([](float eta, float cos) { return 1 - eta * (1 - cos * cos); }),
         "eta is not squared in c: sin(b) is eta sin(a), so its square is eta^2 sin(a)^2"},
        {withC([](float eta, float cos) { return 1 - eta * eta * (1 - cos); }), cosine},
        {withC([](float eta, float cos) { return 1 - eta * eta * (1 + cos); }), cosine},
        {withC([](float eta, float cos) { return 1 - eta * eta * cos * cos; }),
         "c has the cosine where the sine is due: sin(a)^2 is 1 - cos(a)^2"},
        {[](const Crossing& x) { return x.formula(x.eta(), x.cosine(), x.c() * x.c(), -1); },
         "the root is missing: the part along the normal has the length sqrt(c)"},
    };
}

/// Mistakes in the parts that add up to the direction.
inline std::vector<BendSuspect> partSuspects() {
    return {
        {[](const Crossing& x) { return x.formula(x.eta(), -x.cosine(), x.c(), -1); },
         "which sign has the dot product of the direction and the normal? They point against each "
         "other, and the formula counts on that"},
        {[](const Crossing& x) {
             return x.entering ? x.refracted() : x.refracted() + 2 * std::sqrt(x.c()) * x.n;
         },
         "on the way out the normal is turned round once more: in the hit record it is on the side "
         "that the ray came from, inside as well as outside"},
        {[](const Crossing& x) { return x.refracted() + 2 * std::sqrt(x.c()) * x.n; },
         "this ray stays on its side of the surface, as the root of c has the wrong sign: a "
         "refracted ray crosses the surface"},
        {[](const Crossing& x) { return x.formula(x.eta(), x.cosine(), x.c(), 1); },
         "what is subtracted in the formula, the part along the normal, is added here"},
        {[](const Crossing& x) { return x.refracted() + (1 - x.eta()) * x.d; },
         "d comes without its factor eta: by Snell's law the part along the surface gets eta times "
         "as long"},
        {[](const Crossing& x) { return x.refracted() - (1 - x.eta()) * x.cosine() * x.n; },
         "the cosine comes without its factor eta, so that some of the old part along the normal "
         "is left"},
        {[](const Crossing& x) { return x.eta() * (x.d - x.cosine() * x.n); },
         "this ray slides along the surface: its part along the normal, of length sqrt(c), is "
         "missing"},
        {[](const Crossing& x) { return x.eta() * x.d - std::sqrt(x.c()) * x.n; },
         "the old part along the normal, eta (d . n), has not been taken away"},
    };
}

/// True if the mistake explains the direction that came out. With it c may be negative where the
/// right one is not: then there is a NaN, or total reflection.
inline bool explains(const BendSuspect& mistake, const Crossing& x, const sw::Vec3& got) {
    const sw::Vec3 wrong = heading(mistake.yields(x));
    if (isNumber(wrong)) return agree(heading(got), wrong);
    return !isNumber(got) || agree(heading(got), x.mirrored());
}

/// What a mistake makes of the directions of rays; null if they are right, or nobody knows why not.
inline const BendSuspect* bendCulprit() {
    static const std::vector<BendSuspect> suspects = [] {
        std::vector<BendSuspect> all = waySuspects();
        for (const auto& more : {rootSuspects(), partSuspects()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    // Asks whether each case is explained, in place of how: 1 for yes.
    const sw::Vec3 yes(1, 1, 1), no;
    std::vector<BendSuspect> answers;
    for (const BendSuspect& s : suspects)
        answers.push_back(
            {[&](const Crossing& x) { return explains(s, x, x.asked().dir) ? yes : no; }, s.hint});
    const BendSuspect* found = culprit(
        crossings(), [&](const Crossing&) { return yes; }, answers);
    return found == nullptr ? nullptr : &suspects[static_cast<std::size_t>(found - answers.data())];
}

/// False if getRefractedRay() is the starter's.
inline bool refractsAtAll() {
    return !isStarters(crossings().front().asked());
}

/// True if all directions are right where light gets through.
inline bool bendsRight() {
    const std::vector<Crossing> all = crossings();
    return std::all_of(all.begin(), all.end(), [](const Crossing& x) {
        return agree(heading(x.asked().dir), x.refracted());
    });
}

inline const std::string refractionNotYet =
    "getRefractedRay() in swIntersection.cpp still returns an empty ray: this is where task 5 "
    "begins";

/// Why a ray has another direction than the right one.
inline std::string bendHint(const sw::Ray& got, const Crossing& x) {
    if (isStarters(got)) return refractsAtAll() ? "" : refractionNotYet;
    const BendSuspect* mistake = bendCulprit();
    const bool guilty = mistake != nullptr && explains(*mistake, x, got.dir);
    const std::string fault = noRayHint(got), hint = guilty ? mistake->hint : "";
    if (fault.empty() || !guilty) return fault + hint;
    return fault + "; here c is negative, and the reason is this: " + hint;
}

/// Why a direction that is not of length 1 is refracted into another one, if others are right.
inline std::string bendLengthHint(const sw::Ray& got, const Crossing& x, float length) {
    Crossing raw = x;
    raw.d = length * x.d;
    const char* const unitFirst =
        "was the direction of length 1 before you took its cosine? It may come with any length";
    if (agree(got.dir, length * x.refracted()))
        return "it goes the right way, but a refracted ray has a direction of length 1, however "
               "long the one was that came in";
    const bool none = !(raw.c() >= 0) && agree(heading(got.dir), x.mirrored());
    if (none || agree(got.dir, raw.refracted()) ||
        agree(heading(got.dir), heading(raw.refracted())))
        return unitFirst;
    if (!isNumber(got.dir) && !isNumber(raw.refracted()))
        return faultOf(got.dir) + "; " + unitFirst;
    return bendHint(got, x);
}

}  // namespace lab
