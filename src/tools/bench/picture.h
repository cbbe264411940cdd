#pragma once

#include <functional>
#include <memory>

#include "swImage.h"
#include "swNff.h"

/// Pictures, rendered in several ways. Without a scene: the lab's, of the given size.
namespace bench {

constexpr int labSamples = 3, labDepth = 3;

/// Colour of pixel (x, y). Called concurrently.
using Radiance = std::function<sw::Color(int x, int y)>;

/// With the functions of our program.
Radiance ourPicture(sw::NffScene file, int size, int samples, int depth);

/// As in the original lab program: virtual calls, textbook kernels, the scene passed by value.
Radiance originalsPicture(int size);

/// With a minimal renderer on Embree; null if Embree is not installed.
Radiance embreesPicture(int size);

}  // namespace bench
