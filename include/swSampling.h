#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "swVec3.h"

namespace sw {

/// Starts this thread's random numbers for one pixel. The renderer does so before each pixel, so
/// that a picture depends on its seed alone: not on threads, tiles or crop.
void seedPixel(std::uint64_t seed, int x, int y);

/// The next random number of this thread's pixel: uniform in [0, 1).
float uniform();

/// Where in its pixel the n x n samples lie.
enum class SamplePattern : unsigned char {
    jitter,      ///< one at a random place in each cell of an n x n grid, as in the lab
    grid,        ///< the centres of these cells; nothing random
    random,      ///< anywhere; for comparison
    multiJitter  ///< jitter, and one sample in each of n^2 columns and n^2 rows
};

/// The patterns' names on the command line, indexed by SamplePattern.
inline constexpr std::array<const char*, 4> patternNames{"jitter", "grid", "random", "multijitter"};

/// A sample as recorded for the error estimate. The fourth float is 0: SIMD adds four floats at
/// once, not three.
struct NotedSample {
    float m[4];
};

/// Where this thread records the samples of its pixel. Empty if no error is estimated.
struct SampleSpace {
    NotedSample *next = nullptr, *end = nullptr;
};
inline thread_local constinit SampleSpace sampleSpace;

/// The mean of a pixel's samples. The renderer sees the samples too: it estimates the mean's error
/// from them (see swErrorEstimate.h).
class SampleMean {
public:
    SampleMean& operator+=(const Color& sample) {
        sum += sample;
        ++count;
        if (sampleSpace.next != sampleSpace.end)
            *sampleSpace.next++ = {{sample[0], sample[1], sample[2], 0}};
        return *this;
    }

    /// Black if there are no samples.
    operator Color() const { return count == 0 ? sum : sum * (1 / static_cast<float>(count)); }

private:
    Color sum;
    int count = 0;
};

}  // namespace sw
