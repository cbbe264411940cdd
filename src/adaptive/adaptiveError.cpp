#include <algorithm>
#include <cmath>

#include "adaptive/adaptivePixel.h"

namespace sw {
namespace {

/// What the four nearest neighbours let expect of a pixel.
struct Plane {
    Color dx, dy;    ///< slope, per pixel
    Color residual;  ///< by how much the pixel differs from the plane
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

// How far all channels of a colour lie outside of what a picture can show.
float clippedBy(const Color& color) {
    float least = HUGE_VALF;
    for (const float c : color.m) least = std::min(least, std::max(c - 1, -c));
    return std::max(least, 0.f);
}

// A smooth slope s (per pixel) is no contrast, but it might hide one, the more so the steeper.
float suspectedContrast(const Neighbourhood& around) {
    float contrast = 0;
    for (const AdaptivePixel* pixel : around) contrast = std::max(contrast, pixel->contrast);
    const Plane plane = planeThrough(around);
    const float slope = square(plane.dx) + square(plane.dy);
    const float doubted = 2 * square(plane.residual) + 4 * slope * slope;
    const float sum = (around[4]->samples == 1 ? 0.2f : 1.f) * contrast + doubted;
    return sum < 100 ? sum : 100;  // NaN, too
}

// A neighbour differs from the pixels on both sides of the way to it, which agree: the line that it
// seems to hold may go on into the middle pixel.
Hair suspectedHair(const Neighbourhood& around) {
    // All neighbours, clockwise: the sides of one are those before and after it.
    static constexpr std::size_t circle[] = {0, 1, 2, 5, 8, 7, 6, 3};
    Hair hair;
    for (std::size_t i = 0; i < 8; ++i) {
        const AdaptivePixel& next = *around[circle[i]];
        if (!(next.contrast > hair.squaredError)) continue;  // the excess would be less
        const Color& a = around[circle[(i + 1) % 8]]->mean;
        const Color& b = around[circle[(i + 7) % 8]]->mean;
        if (square(a - b) > 0.05f * next.contrast) continue;
        const float excess = square(next.mean - 0.5f * (a + b));
        if (excess > hair.squaredError) hair = {excess, excess / next.contrast};
    }
    return hair;
}

}  // namespace

void lookAround(AdaptivePixel& pixel, const Neighbourhood& around) {
    pixel.suspected = suspectedContrast(around);
    pixel.hair = suspectedHair(around);
}

// Besides what a pixel's own samples show there is what they may have missed: part of an edge that
// neighbours have seen or let suspect. Say it cuts off a share a of the pixel, uniform in 0..1; n
// stratified samples miss it with a chance of 1 - n a, and then the error a has a mean square of 1
// / (6 n^2). They do so in one case of 2n: 1 / (12 n^3), times the squared contrast. Measured, next
// to pixels with a contrast: 1 / (10 n^3) for n = 4 and 8, a fifth for n = 1; after a contrast
// between pixels, 1 / (5 n^3).
float squaredError(const AdaptivePixel& pixel) {
    const float n = static_cast<float>(pixel.samples);
    float sum = pixel.variance + pixel.suspected / (10 * n * n * n);
    if (pixel.hair.squaredError > 0)
        sum += 0.5f * pixel.hair.squaredError * std::exp(-n * std::sqrt(pixel.hair.squaredShare));
    const float shown = std::sqrt(sum) - clippedBy(pixel.mean);
    if (shown <= 0) return 0;
    return shown < 1 ? shown * shown : 1;
}

Color resolve(const Neighbourhood& around) {
    const AdaptivePixel& own = *around[4];
    if (own.samples > 1) return own.mean;
    // A single sample stands for the pixel's centre, moved there along the neighbours' slope, as
    // far as no neighbour is passed.
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
