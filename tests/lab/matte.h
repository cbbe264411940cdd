#pragma once

#include "swMaterial.h"

namespace lab {

/// Paint that only scatters. The index of refraction, which such paint does not use, is 0: a
/// program that takes it for the transparency (task 5) still sees nothing but scattered light.
inline sw::Material matte(const sw::Color& color) {
    return {color, 0, 0, 0};
}

}  // namespace lab
