#pragma once

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>

#include "swNumerics.h"
#include "swRay.h"

namespace sw {

/// A little more than t: distances to boxes and filters' results are that exact.
inline float widened(float t) {
    return t + (std::fabs(t) * 0x1p-20f + FLT_MIN);
}

/// A ray for the filters. Its direction is divided by a power of two, so that the largest component
/// lies in [1/2, 1): that is exact, and keeps products within the range of float. A direction too
/// long for that becomes NaN, which lets every shape through.
struct FilterRay {
    Vec3 orig, dir;
    float dirSquared, inverseSquared;  ///< |dir|^2 and its reciprocal
    float scale;                       ///< what the true direction was divided by
    float minT, maxT;                  ///< in units of dir

    /// A hit between these is one for the exact kernels, too, whose t is a float.
    float sureMinT() const { return std::max(minT, 0x1p-100f * scale) * (1 + 0x1p-20f); }
    float sureMaxT() const { return std::min({maxT, 0x1p100f * scale, 0x1p100f}) * (1 - 0x1p-20f); }

    explicit FilterRay(const Ray& ray) : orig(ray.orig), dir(ray.dir) {
        // The power of two comes from the exponent's bits, as frexp and ldexp are too slow here.
        constexpr std::uint32_t one = 1u << 23;  // in the exponent of a float
        const auto bits = std::bit_cast<std::uint32_t>(num::maxAbs(dir));
        const std::uint32_t exponent = std::max(bits & 0x7f800000u, one) + one;
        const bool tooLong = exponent > 253 * one;  // or not finite
        scale = tooLong ? NAN : std::bit_cast<float>(exponent);
        dir *= tooLong ? NAN : std::bit_cast<float>(254 * one - exponent);
        dirSquared = dir * dir;
        inverseSquared = 1 / dirSquared;
        minT = ray.minT * scale;
        maxT = ray.maxT * scale;
    }

    /// Shortens the ray to t, in units of the true direction.
    void shorten(float t) { maxT = t * scale; }
};

}  // namespace sw
