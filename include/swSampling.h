#pragma once

#include <cstdint>

namespace sw {

/// Starts this thread's random numbers for one pixel. The renderer does so before each pixel, so
/// that a picture depends on its seed alone: not on threads, tiles or crop.
void seedPixel(std::uint64_t seed, int x, int y);

/// The next random number of this thread's pixel: uniform in [0, 1).
float uniform();

}  // namespace sw
