#include "filterRay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "swNumerics.h"

namespace sw {

FilterRay::FilterRay(const Ray& ray) {
    // The power of two comes from the exponent's bits: frexp and ldexp take too long here.
    constexpr std::uint32_t one = 1u << 23;  // in the exponent of a float
    const auto bits = std::bit_cast<std::uint32_t>(num::maxAbs(ray.dir));
    const std::uint32_t exponent = std::max(bits & 0x7f800000u, one) + one;
    const bool tooLong = exponent > 253 * one;  // or not finite
    scale = tooLong ? NAN : std::bit_cast<float>(exponent);
    const float inverse = tooLong ? NAN : std::bit_cast<float>(254 * one - exponent);
    orig = ray.orig;
    dir = ray.dir * inverse;
    dirSquared = dir * dir;
    minT = ray.minT * scale;
    maxT = ray.maxT * scale;
}

}  // namespace sw
