#pragma once

#include "swVec3.h"

namespace sw {

/// A point light that shines equally in all directions, without fall-off.
struct Light {
    Vec3 position;
    Color color{1, 1, 1};  ///< linear radiance of a white surface that faces the light

    Light() = default;
    explicit Light(const Vec3& position, const Color& color = {1, 1, 1})
        : position(position), color(color) {}
};

}  // namespace sw
