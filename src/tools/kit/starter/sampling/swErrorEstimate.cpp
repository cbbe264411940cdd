#include "swErrorEstimate.h"

#include <cmath>

namespace sw {
namespace {

// Half the length of the interval mean +- error after clamping to 0..1.
float errorAsShown(float mean, float error) {
    const float least = mean - error, most = mean + error;
    if (least >= 0 && most <= 1) return error;
    const float upper = most < 1 ? clampToDisplay(most) : 1;  // 1 for NaN: it may be anything
    return (upper - clampToDisplay(least)) / 2;
}

}  // namespace

// There is room for one sample too many, so that it is noticed.
PixelSamples::PixelSamples(SamplePattern, int n)
    : side(n < 2 ? 0 : static_cast<std::size_t>(n)), samples(side == 0 ? 0 : side * side + 1) {
    sampleSpace = {samples.data(), samples.data() + samples.size()};
}

Color PixelSamples::takeError(const Color& mean) {
    const bool complete = side > 0 && sampleSpace.next == samples.data() + side * side;
    sampleSpace.next = samples.data();
    if (!complete) return {NAN, NAN, NAN};

    const float blocks = static_cast<float>((side - 1) * (side - 1) * side * side);
    Color error;
    for (int i = 0; i < 3; ++i) {
        float squares = 0;  // of the contrasts of all 2 x 2 neighbouring cells
        for (std::size_t k = 0; k + side < side * side; ++k) {
            const NotedSample *upper = &samples[k], *lower = upper + side;
            const float q = (upper[0].m[i] - upper[1].m[i]) - (lower[0].m[i] - lower[1].m[i]);
            if ((k + 1) % side != 0) squares += q * q;
        }
        error[i] = errorAsShown(mean[i], std::sqrt(0.742f / 4 / blocks * squares));
    }
    return error;
}

}  // namespace sw
