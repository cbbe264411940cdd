#pragma once

#include "lab/bendModels.h"

namespace lab {

/// A ray that meets the surface of a glass body, and what Snell's law makes of it. The sines are
/// those of the angles to the normal.
struct Bend {
    bool entering;
    float index;    ///< of the body
    float sineIn;   ///< of the ray that comes in
    float sineOut;  ///< of the refracted ray; above 1: there is none
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

inline Crossing crossingOf(const Bend& bend, const Place& place) {
    return {downwards(place, bend.sineIn), place.normal, bend.index, bend.entering};
}

inline std::string tried(const Bend& bend, const Place& place) {
    return std::string("getRefractedRay() of a ray ") +
           (bend.entering ? "that enters glass of index " : "that leaves glass of index ") +
           text(bend.index) + " with direction " + text(downwards(place, bend.sineIn)) +
           ", normal " + text(place.normal);
}

inline void expectBend(const Bend& bend, const Place& place, float length = 1) {
    const Crossing crossing = crossingOf(bend, place);
    const sw::Ray got = crossing.asked(length);
    const sw::Vec3 expected = downwards(place, bend.sineOut);
    if (!isEmpty(got) && alike(got.dir, expected)) return;
    fail({tried(bend, place) + (length == 1 ? "" : " times " + text(length)),
          "the direction " + text(got.dir),
          text(expected) + ", the sine " + text(bend.sineIn) + " turned into " + text(bend.sineOut),
          length == 1 ? bendHint(got, crossing) : bendLengthHint(got, crossing, length)});
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
