#pragma once

#include "lab/nextRay.h"

/// What getReflectedRay() makes of directions, right or wrong.
namespace lab {

/// A ray that meets a mirror.
struct Meeting {
    sw::Vec3 d, n;  ///< of length 1
    bool frontFacing = true;
    float length = 1;  ///< of the ray's direction: d times that

    sw::Vec3 mirrored() const { return d - 2 * (d * n) * n; }
    sw::Ray asked() const { return hitBy(length * d, n, opaque(1), frontFacing).getReflectedRay(); }
};

/// Generic ones: no two mistakes look alike there.
inline std::vector<Meeting> meetings() {
    std::vector<Meeting> all;
    test::Random random(4);
    for (int i = 0; i < 8; ++i) {
        const sw::Vec3 n = random.direction();
        const sw::Vec3 sideways = random.real(0.3, 1) * along(n, random);
        all.push_back({unit(sideways - random.real(0.3, 1) * n), n, i % 2 == 0});
    }
    return all;
}

inline std::vector<Suspect<Meeting>> mirrorSuspects() {
    return {
        {[](const Meeting& m) { return -m.mirrored(); },
         "every sign is the wrong way round: this is where the mirrored ray would come from, not "
         "where it goes"},
        {[](const Meeting& m) { return m.d + 2 * (m.d * m.n) * m.n; },
         "this ray is reflected about the wrong side and dives deeper into the surface: turn the "
         "part of the direction along the normal round, do not make it longer"},
        {[](const Meeting& m) { return m.d - (m.d * m.n) * m.n; },
         "this ray slides along the surface: you took the part along the normal away once, which "
         "only stops it; a mirror sends it back"},
        {[](const Meeting& m) { return m.d; }, "the ray goes on as if there were no mirror"},
        {[](const Meeting& m) { return -m.d; },
         "the ray goes back the way it came; a mirror does so only when it is met head-on"},
        {[](const Meeting& m) { return m.n; },
         "the ray leaves along the normal, wherever it came from: its part along the surface is "
         "lost"},
        {[](const Meeting& m) { return -(m.d * m.n) * m.n; },
         "the ray leaves along the normal, wherever it came from: its part along the surface is "
         "lost"},
        {[](const Meeting& m) { return m.d - 2 * (m.d * m.d) * m.n; },
         "the part along the normal has the length d . n, which is not the same for all rays"},
        {[](const Meeting& m) { return m.d - 2 * (m.d * m.n) * m.d; },
         "what is subtracted has to point along the normal, not along the ray"},
        {[](const Meeting& m) { return m.d - m.n * 2; },
         "the part along the normal has the length d . n, which is not the same for all rays"},
        {[](const Meeting& m) { return m.d + m.n * 2; },
         "the part along the normal has the length d . n, which is not the same for all rays"},
        {[](const Meeting& m) { return m.d + m.n; },
         "the part along the normal has the length d . n, which is not the same for all rays"},
        {[](const Meeting& m) { return m.frontFacing ? m.mirrored() : m.d; },
         "from behind (frontFacing is false) a mirror mirrors as well: the normal is always on the "
         "side that the ray came from"},
    };
}

/// What a mistake makes of the directions of rays; null if they are right, or nobody knows why not.
inline const Suspect<Meeting>* mirrorCulprit() {
    static const std::vector<Suspect<Meeting>> suspects = mirrorSuspects();
    std::vector<Suspect<Meeting>> ways;
    for (const Suspect<Meeting>& s : suspects)
        ways.push_back({[&s](const Meeting& m) { return heading(s.yields(m)); }, s.hint});
    const auto got = [](const Meeting& m) { return heading(m.asked().dir); };
    const Suspect<Meeting>* found = culprit(meetings(), got, ways);
    return found == nullptr ? nullptr : &suspects[static_cast<std::size_t>(found - ways.data())];
}

inline const std::string reflectionNotYet =
    "getReflectedRay() in swIntersection.cpp still returns an empty ray: this is where task 4 "
    "begins";

/// Why a direction of length 1 got mirrored into another one.
inline std::string mirrorHint(const sw::Ray& got, const Meeting& m) {
    if (isStarters(got)) return reflectionNotYet;
    if (const std::string hint = noRayHint(got); !hint.empty()) return hint;
    const Suspect<Meeting>* mistake = mirrorCulprit();
    if (mistake == nullptr || !agree(heading(mistake->yields(m)), heading(got.dir))) return "";
    return mistake->hint;
}

/// Why a direction that is not of length 1 got mirrored into another one, if others are right.
inline std::string mirrorLengthHint(const sw::Ray& got, const Meeting& m) {
    const sw::Vec3 raw = m.length * m.d;
    if (agree(got.dir, m.length * m.mirrored()))
        return "it goes the right way, but a reflected ray has a direction of length 1, however "
               "long the one was that came in";
    for (const sw::Vec3& mixed : {m.d - 2 * (raw * m.n) * m.n, raw - 2 * (m.d * m.n) * m.n})
        if (agree(heading(got.dir), heading(mixed)))
            return "a direction of length 1 and one of another length got mixed: take the same one "
                   "everywhere in the formula";
    return mirrorHint(got, m);
}

}  // namespace lab
