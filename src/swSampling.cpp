#include "swSampling.h"

namespace sw {
namespace {

constinit thread_local std::uint64_t state = 0;

// SplitMix64: a counter with golden-ratio steps, each value scrambled (Steele, Lea and Flood, Fast
// Splittable Pseudorandom Number Generators, OOPSLA 2014, section 5.1).
constexpr std::uint64_t step = 0x9e3779b97f4a7c15;

std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

}  // namespace

void seedPixel(std::uint64_t seed, int x, int y) {
    const auto position = static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) |
                          static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32;
    state = scramble(scramble(seed + step) + position);
}

float uniform() {
    state += step;
    // The upper 24 bits: as many as a float in [0.5, 1) can hold, so 1 is never reached.
    return static_cast<float>(scramble(state) >> 40) * 0x1p-24f;
}

}  // namespace sw
