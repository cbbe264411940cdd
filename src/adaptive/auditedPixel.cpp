#include "adaptive/auditedPixel.h"

#include <algorithm>
#include <cmath>

#include "sampling/splitMix64.h"
#include "swImage.h"

namespace sw {
namespace {

constexpr int usualSamples = 32;    // of a judge ...
constexpr int brightSamples = 256;  // ... and of one that sees light brighter than white

Color displayed(const Color& c) {
    return {clampToDisplay(c[0]), clampToDisplay(c[1]), clampToDisplay(c[2])};
}

bool isFinite(const Color& c) {
    return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]);
}

float largest(const Color& c) {
    return std::max({c[0], c[1], c[2]});
}

void refineTo(AdaptivePixel& pixel, int samples, int x, int y, const RadianceAt& radiance,
              std::uint64_t seed) {
    while (pixel.samples < samples) refine(pixel, x, y, radiance, seed);
}

AdaptivePixel judgeOf(int x, int y, const Color& sample, const RadianceAt& radiance,
                      std::uint64_t seed) {
    AdaptivePixel judge;
    refineTo(judge, usualSamples, x, y, radiance, seed);
    if (std::max(largest(sample), largest(judge.mean)) > 1)
        refineTo(judge, brightSamples, x, y, radiance, seed);
    return judge;
}

}  // namespace

float productOf(const Color& a, const Color& b, const Color& mean) {
    float sum = 0;
    for (int i = 0; i < 3; ++i) {
        const float step = b[i] - mean[i];
        if (step == 0) continue;
        const float cut = (clampToDisplay(b[i]) - clampToDisplay(mean[i])) / step;
        sum += (a[i] - mean[i]) * step * cut * cut;
    }
    return std::isfinite(sum) ? sum / 3 : 1;
}

AuditedPixel audit(int x, int y, const Color& shown, const Slope& slope, float least,
                   const RadianceAt& radiance, std::uint64_t seed) {
    AuditedPixel result{.x = x, .y = y, .judge = {}};
    AdaptivePixel one;
    refine(one, x, y, radiance, splitMix64::after(seed));
    // The slope's part has a mean of 0: the sample is moved to the pixel's centre.
    const Color sample = one.mean + (0.5f - one.x) * slope.dx + (0.5f - one.y) * slope.dy;
    const float difference = square(displayed(sample) - displayed(shown));
    if (difference <= least * least || !isFinite(shown)) return result;

    result.isWrong = true;
    result.judge = judgeOf(x, y, sample, radiance, splitMix64::after(seed + 1));
    const Color& better = result.judge.mean;
    result.product = productOf(sample, better, shown);
    result.change = square(displayed(better) - displayed(shown));
    result.coverage = std::min(std::sqrt(square(better - shown) / square(sample - shown)), 1.f);
    return result;
}

}  // namespace sw
