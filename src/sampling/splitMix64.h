#pragma once

#include <cstdint>

/// SplitMix64: a counter with golden-ratio steps, each value scrambled (Steele, Lea and Flood, Fast
/// Splittable Pseudorandom Number Generators, OOPSLA 2014, section 5.1).
namespace sw::splitMix64 {

constexpr std::uint64_t step = 0x9e3779b97f4a7c15;

constexpr std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

/// The number that follows a state of the counter.
constexpr std::uint64_t after(std::uint64_t state) {
    return scramble(state + step);
}

/// A pixel's place as one number.
constexpr std::uint64_t placeOf(int x, int y) {
    return static_cast<std::uint32_t>(x) | std::uint64_t{static_cast<std::uint32_t>(y)} << 32;
}

}  // namespace sw::splitMix64
