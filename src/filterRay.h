#pragma once

#include "swRay.h"

namespace sw {

/// A ray as the filters want it: its direction divided by a power of two, so that the largest
/// component lies in [1/2, 1). That is exact and keeps products within the range of float. NaN,
/// which lets every shape through, where the direction is too long for that.
struct FilterRay {
    Vec3 orig, dir;
    float dirSquared;  ///< |dir|^2
    float minT, maxT;  ///< in units of dir
    float scale;       ///< what the true direction was divided by

    explicit FilterRay(const Ray& ray);
    /// Shortens the ray to t, in units of the true direction.
    void shorten(float t) { maxT = t * scale; }
};

}  // namespace sw
