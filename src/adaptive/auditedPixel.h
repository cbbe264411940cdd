#pragma once

#include <cstdint>

#include "adaptive/adaptivePixel.h"

namespace sw {

/// What samples that are independent of a pixel's own say about its colour.
struct AuditedPixel {
    int x = 0, y = 0;
    bool isWrong = false;  ///< the audit's sample differs from the pixel's colour
    float product = 0;     ///< an unbiased estimate of the colour's squared error as displayed
    float change = 0;      ///< squared: from the colour to the judge's, as displayed
    float coverage = 0;    ///< the pixel's share that is like the audit's sample, 0..1
    AdaptivePixel judge;   ///< if it is wrong: the pixel as sampled independently of all before
};

/// An unbiased estimate of a colour's squared error as displayed, from two independent ones.
///
/// For a mean m, which was seen before, a sample a and a mean b, all independent, with true mean
/// mu, E[(a - m) (b - m)] = (mu - m)^2: whatever m's samples have missed, and why they have ended.
/// With light brighter than white, displayed(mu) - displayed(m) counts instead, which no cut-off
/// sample knows (a light of radiance 20 in a twentieth of a pixel makes it white, not 5 % grey). So
/// the radiances are multiplied uncut, and the cut is put on afterwards: its factor r =
/// ((displayed(mu) - displayed(m)) / (mu - m))^2 does not depend on a, so that E[(a - m) (mu - m)
/// r] = (displayed(mu) - displayed(m))^2. For mu it takes b, and so b must be a good mean where
/// there is light brighter than white.
float productOf(const Color& a, const Color& b, const Color& mean);

/// Audits one pixel with one sample, and if that differs from the pixel's colour, many more.
/// @param shown  the pixel's colour
/// @param slope  of colour in the pixel, as far as known: unbiased whatever it is, sharp if right
/// @param least  RMS difference that counts
/// @param seed   of the audit's samples: not the picture's
AuditedPixel audit(int x, int y, const Color& shown, const Slope& slope, float least,
                   const RadianceAt& radiance, std::uint64_t seed);

}  // namespace sw
