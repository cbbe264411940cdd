#pragma once

#include "lab/gains.h"
#include "lab/photo.h"

/// Pictures of mirrors or of glass.
namespace lab {

/// What a ray shows without the student's traceRay(), where another task's code gets in the way:
/// all that is black stays black, and each ray of the student's is followed.
inline sw::Color follow(const Gain& gain, const World& world, const sw::Ray& ray, int depth) {
    sw::Intersection hit;
    if (!world.scene.intersect(ray, hit)) return sky;
    const float w = gain.mirrored ? hit.material.reflectivity : hit.material.transparency;
    if (!(w > 0) || depth == 0) return {0, 0, 0};
    const sw::Ray next = gain.mirrored ? hit.getReflectedRay() : hit.getRefractedRay();
    return w * follow(gain, world, next, depth - 1);
}

/// A picture of balls round the origin, by the student's traceRay() as far as possible.
inline sw::Image pictureOf(const Gain& gain, World& world) {
    constexpr int depth = 12;  // all rays but a few end in the sky before that
    const bool undisturbed = isUndisturbed(gain);
    return photo(sw::Camera({0, 0, 70}, {0, 0, 0}, {0, 1, 0}, 40), [&](const sw::Ray& ray) {
        sw::Color color;
        if (undisturbed && world.trace(ray, depth, color)) return color;
        return follow(gain, world, ray, depth);
    });
}

}  // namespace lab
