#include <algorithm>
#include <cmath>

#include "adaptive/adaptivePixel.h"

namespace sw {
namespace {

/// The plane through a pixel's four nearest neighbours.
struct Plane : Slope {
    Color residual;  ///< how far the pixel is off the plane
};

Plane planeThrough(const Neighbourhood& around) {
    const AdaptivePixel &up = *around[1], &left = *around[3], &own = *around[4];
    const AdaptivePixel &right = *around[5], &down = *around[7];
    const auto step = [&own](const AdaptivePixel& to) { return &to == &own ? 0.f : 1.f; };

    // From left to right, and from up to down.
    const float ax = right.x - left.x + step(right) + step(left), ay = right.y - left.y;
    const float bx = down.x - up.x, by = down.y - up.y + step(down) + step(up);
    const Color a = right.mean - left.mean, b = down.mean - up.mean;
    const float determinant = ax * by - ay * bx;

    Plane plane;
    if (determinant > 0.5f) {
        plane.dx = (by * a - ay * b) * (1 / determinant);
        plane.dy = (ax * b - bx * a) * (1 / determinant);
    }
    const float x = 0.25f * (left.x + right.x + up.x + down.x + step(right) - step(left)) - own.x;
    const float y = 0.25f * (left.y + right.y + up.y + down.y + step(down) - step(up)) - own.y;
    plane.residual = own.mean - 0.25f * (left.mean + right.mean + up.mean + down.mean) +
                     x * plane.dx + y * plane.dy;
    return plane;
}

// How far all channels of a colour lie outside of 0..1.
float clippedBy(const Color& color) {
    float least = HUGE_VALF;
    for (const float c : color.m) least = std::min(least, std::max(c - 1, -c));
    return std::max(least, 0.f);
}

// The squared contrast that a pixel's samples may have missed. A smooth slope (per pixel) is no
// contrast, but it may hide one: the steeper, the more likely.
float unseenContrast(const Neighbourhood& around) {
    float contrast = 0;
    for (const AdaptivePixel* pixel : around) contrast = std::max(contrast, pixel->contrast);
    const Plane plane = planeThrough(around);
    const float slope = square(plane.dx) + square(plane.dy);
    const float unexplained = 2 * square(plane.residual) + 4 * slope * slope;
    const float sum = (around[4]->samples <= 1 ? 0.2f : 1.f) * contrast + unexplained;
    return sum < 100 ? sum : 100;  // 100 for NaN, too
}

// If a neighbour differs from the two pixels beside it, and these agree, it seems to hold a thin
// line, which may go on into the middle pixel.
ThinFeature thinFeature(const Neighbourhood& around) {
    // All neighbours, clockwise: the pixels beside one are those before and after it.
    static constexpr std::size_t circle[] = {0, 1, 2, 5, 8, 7, 6, 3};
    ThinFeature feature;
    for (std::size_t i = 0; i < 8; ++i) {
        const AdaptivePixel& next = *around[circle[i]];
        if (!(next.contrast > feature.squaredError)) continue;  // the excess would be less
        const Color& a = around[circle[(i + 1) % 8]]->mean;
        const Color& b = around[circle[(i + 7) % 8]]->mean;
        if (square(a - b) > 0.05f * next.contrast) continue;
        const float excess = square(next.mean - 0.5f * (a + b));
        if (excess > feature.squaredError) feature = {excess, excess / next.contrast};
    }
    return feature;
}

}  // namespace

void lookAround(AdaptivePixel& pixel, const Neighbourhood& around) {
    pixel.unseenContrast = unseenContrast(around);
    pixel.thinFeature = thinFeature(around);
}

// A pixel's error has two parts: what its samples show, and what they may have missed of an edge
// that its neighbours have seen or suggest. Suppose that the edge cuts off a share a of the pixel,
// uniform in 0..1. Then n stratified samples miss it with a probability of 1 - n a, in one case of
// 2n, and the error a then has a mean square of 1 / (6 n^2). Together: 1 / (12 n^3), times the
// squared contrast. Measured next to pixels with a contrast: 1 / (10 n^3) for n = 4 and 8, a fifth
// of that for n = 1; after a contrast between pixels, 1 / (5 n^3).
float squaredError(const AdaptivePixel& pixel) {
    const float n = static_cast<float>(std::max(pixel.samples, 1));
    float sum = pixel.variance + pixel.unseenContrast / (10 * n * n * n);
    const ThinFeature& thin = pixel.thinFeature;
    if (thin.squaredError > 0)
        sum += 0.5f * thin.squaredError * std::exp(-n * std::sqrt(thin.squaredShare));
    // Few samples may hit a light in a small part of the pixel and make the mean far brighter than
    // white, which it need not be: how far beyond the display's range it lies says so
    // exponentially, as the number of such hits does.
    const float error = std::sqrt(sum), clipped = clippedBy(pixel.mean);
    const float displayed = clipped > 0 ? error * std::exp(-clipped / error) : error;
    if (displayed <= 0) return 0;
    return displayed < 1 ? displayed * displayed : 1;
}

Slope slopeOf(const Neighbourhood& around) {
    return planeThrough(around);
}

Color resolve(const Neighbourhood& around) {
    const AdaptivePixel& own = *around[4];
    if (own.samples != 1) return own.mean;
    // A single sample is moved to the pixel's centre along the neighbours' slope, within the range
    // of the neighbours' colours.
    const Plane plane = planeThrough(around);
    Color color = own.mean + (0.5f - own.x) * plane.dx + (0.5f - own.y) * plane.dy;
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax({own.mean[i], around[1]->mean[i], around[3]->mean[i],
                                              around[5]->mean[i], around[7]->mean[i]});
        color[i] = std::min(std::max(color[i], low), high);
    }
    return color;
}

}  // namespace sw
