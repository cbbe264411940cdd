#include "swSampling.h"

#include "sampling/splitMix64.h"

namespace sw {
namespace {

constinit thread_local std::uint64_t state = 0;

}  // namespace

void seedPixel(std::uint64_t seed, int x, int y) {
    state = splitMix64::scramble(splitMix64::after(seed) + splitMix64::placeOf(x, y));
}

float uniform() {
    state += splitMix64::step;
    // The upper 24 bits: as many as a float in [0.5, 1) can hold, so 1 is never reached.
    return static_cast<float>(splitMix64::scramble(state) >> 40) * 0x1p-24f;
}

}  // namespace sw
