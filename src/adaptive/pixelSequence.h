#pragma once

#include <array>
#include <cstdint>

#include "sampling/splitMix64.h"
#include "swSamplePattern.h"

namespace sw {

/// The scrambled (0, 2)-sequence of a pixel. Its first 2^m points, and every later block of 2^m
/// that starts at a multiple of 2^m, have one point in each cell of any grid of 2^m cells in the
/// pixel: the more samples, the finer the strata, and no sample is wasted.
/// Sobol', On the Distribution of Points in a Cube (1967), dimensions 1 and 2; scrambled after
/// Owen, Randomly Permuted (t, m, s)-Nets (1995), with a hash: Laine and Karras, Stratified
/// Sampling for Stochastic Transparency (2011), section 3; Burley, Practical Hash-Based Owen
/// Scrambling (2020).
class PixelSequence {
public:
    static constexpr int length = 4096;

    PixelSequence(std::uint64_t seed, int x, int y)
        : key(splitMix64::after(seed ^ splitMix64::after(splitMix64::placeOf(x, y)))) {}

    /// Point number i, from 0 to length - 1.
    SamplePoint operator[](int i) const {
        const auto index = static_cast<std::uint32_t>(i);
        return {fraction(scramble(index, static_cast<std::uint32_t>(key))),
                fraction(scramble(second[index], static_cast<std::uint32_t>(key >> 32)))};
    }

private:
    // Flips each bit depending on the lower ones. The lowest bit is the first binary digit of a
    // coordinate, so this permutes the halves of every dyadic interval.
    static constexpr std::uint32_t scramble(std::uint32_t digits, std::uint32_t seed) {
        digits += seed;
        digits ^= digits * 0x6c50b47cu;
        digits ^= digits * 0xb82f1e52u;
        digits ^= digits * 0xc7afe638u;
        digits ^= digits * 0x8d22f6e6u;
        return digits;
    }

    // 0.b0 b1 b2... for the bits of a number, lowest first, cut after 24 digits.
    static constexpr float fraction(std::uint32_t b) {
        b = (b >> 16) | (b << 16);
        b = ((b & 0xff00ff00u) >> 8) | ((b & 0x00ff00ffu) << 8);
        b = ((b & 0xf0f0f0f0u) >> 4) | ((b & 0x0f0f0f0fu) << 4);
        b = ((b & 0xccccccccu) >> 2) | ((b & 0x33333333u) << 2);
        b = ((b & 0xaaaaaaaau) >> 1) | ((b & 0x55555555u) << 1);
        return static_cast<float>(b >> 8) * 0x1p-24f;
    }

    // The second dimension's digits, first digit lowest: multiplication of the index with Pascal's
    // triangle modulo 2, whose next column is the last one times (1 + x).
    static constexpr std::array<std::uint32_t, length> secondDimension() {
        std::array<std::uint32_t, length> digits{};
        std::uint32_t column = 1;
        for (std::uint32_t bit = 1; bit < length; bit *= 2) {
            for (std::uint32_t i = bit; i < 2 * bit; ++i) digits[i] = digits[i - bit] ^ column;
            column ^= column << 1;
        }
        return digits;
    }
    static const std::array<std::uint32_t, length> second;

    std::uint64_t key;
};

inline constexpr std::array<std::uint32_t, PixelSequence::length> PixelSequence::second =
    PixelSequence::secondDimension();

}  // namespace sw
