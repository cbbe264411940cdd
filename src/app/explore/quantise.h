#pragma once

#include <cstdint>

#include "swVec3.h"

/// A float without its lowest byte, rounded: 16 bits of precision. NaN and infinity stay.
std::uint32_t float24(float number);

/// IEEE 754's half precision, rounded to nearest; too large becomes infinity, NaN stays NaN.
std::uint32_t float16(float number);

/// A direction as a point of an octahedron unfolded into a square (Cigolle et al., A Survey of
/// Efficient Representations for Independent Unit Vectors, 2014), 16 bits for each side.
struct OctDirection {
    std::uint32_t u, v;
};
OctDirection octahedral(const sw::Vec3& direction);
