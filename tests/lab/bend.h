#pragma once

#include "lab/mirrors.h"

namespace lab {

/// A ray that meets the surface of a glass body, and what Snell's law makes of it. The sines are
/// those of the angles to the normal.
struct Bend {
    bool entering;
    float index;     ///< of the body
    float sineIn;    ///< of the ray that comes in
    float sineOut;   ///< of the refracted ray; above 1: there is none
    float inverted;  ///< what comes out for sineOut if the two indices change places; above 1: none
};

/// Where a Bend takes place: the unit normal on the side that the ray comes from, and the direction
/// along the surface in which it comes.
struct Place {
    sw::Vec3 normal, along;
};

inline sw::Vec3 downwards(const Place& place, float sine) {
    return sine * place.along - std::sqrt(1 - sine * sine) * place.normal;
}
inline sw::Vec3 upwards(const Place& place, float sine) {
    return sine * place.along + std::sqrt(1 - sine * sine) * place.normal;
}

inline sw::Intersection hitBy(const Bend& bend, const Place& place, float length = 1) {
    return hitBy(length * downwards(place, bend.sineIn), place.normal, glass(1, bend.index),
                 bend.entering);
}

inline std::string tried(const Bend& bend, const Place& place) {
    return std::string("getRefractedRay() of a ray ") +
           (bend.entering ? "that enters glass of index " : "that leaves glass of index ") +
           text(bend.index) + " with direction " + text(downwards(place, bend.sineIn)) +
           ", normal " + text(place.normal);
}

inline const std::string refractionNotYet =
    "getRefractedRay() in swIntersection.cpp still returns an empty ray: this is "
    "where task 5 begins";

inline std::string invertedHint(bool entering) {
    return entering ? "on the way in the two indices have changed places: into the denser body a "
                      "ray bends towards the normal, so its sine gets smaller"
                    : "on the way out the two indices change places: frontFacing is false here, "
                      "the ray goes from the glass into the air and bends away from the normal";
}

/// Why the refracted ray has the wrong direction.
inline std::string bendHint(const sw::Ray& got, const Bend& bend, const Place& place) {
    if (isEmpty(got)) return refractionNotYet;
    if (!isNumber(got.dir)) {
        return "a NaN: the root of a negative number? With these sines there is a refracted ray";
    }
    const sw::Vec3 g = unit(got.dir);
    if (alike(g, downwards(place, bend.sineOut))) {
        return "it goes the right way, but a refracted ray has a direction of length 1";
    }
    const bool inverted = bend.inverted < 1 ? alike(g, downwards(place, bend.inverted))
                                            : alike(g, upwards(place, bend.sineIn));
    if (inverted) return invertedHint(bend.entering);
    if (alike(g, downwards(place, bend.sineIn))) return "the ray goes straight on, as if in air";
    if (alike(g, upwards(place, bend.sineIn))) {
        return "the ray is mirrored, but this one gets through: all light is reflected only where "
               "no angle fulfils Snell's law";
    }
    if (std::fabs(got.dir * place.along - bend.sineOut) < 1e-4f) {
        return "the part along the surface is right, the part along the normal is not: which sign "
               "has the dot product of the direction and the normal?";
    }
    if (g * place.normal > 0) return "this ray stays outside: a refracted one crosses the surface";
    if (alike(g, downwards(place, -bend.sineOut))) {
        return "the ray bends over to the wrong side: it crosses the normal, never turns back";
    }
    return "Snell: index times sine is the same on both sides; was the direction of length 1 "
           "before you took its cosine?";
}

inline void expectBend(const Bend& bend, const Place& place, float length = 1) {
    const sw::Ray got = hitBy(bend, place, length).getRefractedRay();
    const sw::Vec3 expected = downwards(place, bend.sineOut);
    if (!isEmpty(got) && alike(got.dir, expected)) return;
    fail({tried(bend, place), "the direction " + text(got.dir),
          text(expected) + ", the sine " + text(bend.sineIn) + " turned into " + text(bend.sineOut),
          bendHint(got, bend, place)});
}

/// Places all around.
inline std::vector<Place> places() {
    std::vector<Place> all = {{{0, 1, 0}, {1, 0, 0}}, {{0, 0, -1}, {0.6f, 0.8f, 0}}};
    test::Random random(1);
    for (int i = 0; i < 20; ++i) {
        const sw::Vec3 normal = random.direction();
        all.push_back({normal, along(normal, random)});
    }
    return all;
}

}  // namespace lab
