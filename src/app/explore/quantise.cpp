#include "app/explore/quantise.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace {

std::uint32_t bitsOf(float number) {
    return std::bit_cast<std::uint32_t>(number);
}

// -1..1 as 0..65534; 65535 stands for NaN.
std::uint32_t fixed16(float number) {
    if (!(std::fabs(number) <= 1)) return 65535;
    return static_cast<std::uint32_t>(std::lround((number + 1) * 32767));
}

}  // namespace

std::uint32_t float24(float number) {
    if (!std::isfinite(number)) return std::isnan(number) ? 0x7fc000u : bitsOf(number) >> 8;
    const std::uint32_t rounded = (bitsOf(number) + 0x80) >> 8;
    return std::isfinite(std::bit_cast<float>(rounded << 8)) ? rounded : bitsOf(number) >> 8;
}

std::uint32_t float16(float number) {
    const std::uint32_t sign = bitsOf(number) >> 16 & 0x8000;
    const float size = std::fabs(number);
    if (std::isnan(number)) return 0x7e00;
    if (size >= 65520) return sign | 0x7c00;
    if (size < 0x1p-14f)  // subnormal: a multiple of 2^-24
        return sign | static_cast<std::uint32_t>(std::lround(size * 0x1p24f));
    const std::uint32_t bits = bitsOf(size);
    const std::uint32_t half = bits + 0xfff + (bits >> 13 & 1);  // to nearest, ties to even
    return sign | ((half >> 13) - (112 << 10));
}

OctDirection octahedral(const sw::Vec3& d) {
    const float size = std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
    float u = d[0] / size, v = d[1] / size;
    if (d[2] < 0) {
        const float folded = (1 - std::fabs(v)) * (u < 0 ? -1.f : 1.f);
        v = (1 - std::fabs(u)) * (v < 0 ? -1.f : 1.f);
        u = folded;
    }
    return {fixed16(u), fixed16(v)};
}
