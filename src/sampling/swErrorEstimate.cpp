#include "swErrorEstimate.h"

#include <cmath>
#include <limits>

namespace sw {
namespace {

constexpr float edgeFactor = 0.742f;       // see PixelSamples
constexpr float multiJitterFactor = 0.6f;  // of the variance of jitter

// Sum of squared deviations from the mean.
NotedSample squaredDeviations(const NotedSample* samples, std::size_t count) {
    NotedSample squares{};
    for (int i = 0; i < 3; ++i) {
        float mean = 0;
        for (std::size_t k = 0; k < count; ++k) mean += samples[k].m[i];
        mean /= static_cast<float>(count);
        for (std::size_t k = 0; k < count; ++k)
            squares.m[i] += (samples[k].m[i] - mean) * (samples[k].m[i] - mean);
    }
    return squares;
}

// Sum of the squared contrasts of all 2 x 2 neighbouring cells.
NotedSample squaredContrasts(const NotedSample* cells, std::size_t n) {
    NotedSample squares{};
    for (std::size_t row = 0; row + 1 < n; ++row) {
        for (std::size_t column = 0; column + 1 < n; ++column) {
            const NotedSample *upper = cells + row * n + column, *lower = upper + n;
            for (int i = 0; i < 4; ++i) {
                const float q = (upper[0].m[i] - upper[1].m[i]) - (lower[0].m[i] - lower[1].m[i]);
                squares.m[i] += q * q;
            }
        }
    }
    return squares;
}

// The factor that turns these sums into the variance of the mean of n x n samples.
float varianceFactor(SamplePattern pattern, int n) {
    const float samples = static_cast<float>(n * n), blocks = static_cast<float>((n - 1) * (n - 1));
    if (pattern == SamplePattern::random) return 1 / (samples - 1) / samples;
    const float jitter = edgeFactor / 4 / blocks / samples;
    return pattern == SamplePattern::multiJitter ? multiJitterFactor * jitter : jitter;
}

}  // namespace

float displayedError(float mean, float error) {
    const float least = mean - error, most = mean + error;
    if (least >= 0 && most <= 1) return error;
    const float upper = most < 1 ? clampToDisplay(most) : 1;  // 1 for NaN: it may be anything
    return (upper - clampToDisplay(least)) / 2;
}

// There is room for one sample too many, so that it is noticed.
PixelSamples::PixelSamples(SamplePattern pattern, int n)
    : pattern(pattern),
      side(n < 2 ? 0 : static_cast<std::size_t>(n)),
      factor(varianceFactor(pattern, n)),
      samples(side == 0 ? 0 : side * side + 1),
      outer(sampleSpace) {
    sampleSpace = {samples.data(), samples.data() + samples.size()};
}

PixelSamples::~PixelSamples() {
    sampleSpace = outer;
}

Color PixelSamples::takeError(const Color& mean) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const bool complete = side > 0 && sampleSpace.next == samples.data() + side * side;
    sampleSpace.next = samples.data();
    if (!complete) return {none, none, none};

    const NotedSample sum = pattern == SamplePattern::random
                                ? squaredDeviations(samples.data(), side * side)
                                : squaredContrasts(samples.data(), side);
    Color error;
    for (int i = 0; i < 3; ++i) error[i] = displayedError(mean[i], std::sqrt(factor * sum.m[i]));
    return error;
}

}  // namespace sw
