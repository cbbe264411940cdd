#pragma once

#include "swVec3.h"

namespace sw {

/// How a surface treats light: the fraction `reflectivity` is mirrored, the fraction
/// `transparency` is refracted, and the rest, 1 - reflectivity - transparency, is scattered
/// diffusely in `color`.
struct Material {
    Color color{1, 1, 1};       ///< diffuse colour, 0..1 per channel
    float reflectivity = 0;     ///< 0..1; reflectivity + transparency <= 1
    float transparency = 0;     ///< 0..1
    float refractiveIndex = 1;  ///< inside relative to outside: glass about 1.5; positive

    Material() = default;
    Material(const Color& color, float reflectivity = 0, float transparency = 0,
             float refractiveIndex = 1)
        : color(color),
          reflectivity(reflectivity),
          transparency(transparency),
          refractiveIndex(refractiveIndex) {}
};

}  // namespace sw
