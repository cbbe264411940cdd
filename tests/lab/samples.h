#pragma once

#include <algorithm>

#include "lab/mirrors.h"
#include "swSampling.h"

/// Where in a pixel the student's samplePixel() takes its samples.
namespace lab {

/// From the pixel's top left corner, in pixels: 0..1.
struct Sample {
    float x, y;
};

constexpr int pictureSize = 4;     ///< pixels per side
constexpr float rounding = 1e-5f;  ///< how far a sample may lie beyond its cell, in pixels

/// Looks along -z from the origin. With 90 degrees the picture is 2 x 2 at distance 1.
inline sw::Camera frontCamera() {
    sw::Camera camera(sw::Vec3(0, 0, 0), sw::Vec3(0, 0, -1), sw::Vec3(0, 1, 0), 90, 1);
    camera.setup(pictureSize, pictureSize);
    return camera;
}

/// The student's samplePixel() for the pixel whose corner is (x, y).
/// @throws TooManyRays
inline sw::Color pixelOf(const World& world, int x, int y, int n, int depth) {
    return samplePixel(static_cast<float>(x), static_cast<float>(y), n, depth, frontCamera(),
                       world.scene);
}

/// The samples of one pixel; some of them where there was no end of them.
inline std::vector<Sample> samplesOf(int x, int y, int n) {
    World world;
    try {
        pixelOf(world, x, y, n, 3);
    } catch (const TooManyRays&) {  // NOLINT: their number tells
    }
    std::vector<Sample> samples;
    constexpr float half = pictureSize / 2;
    for (const sw::Ray& ray : world.rays()) {
        const sw::Vec3 d = ray.dir;
        samples.push_back({half * (1 - d[0] / d[2]) - static_cast<float>(x),
                           half * (1 + d[1] / d[2]) - static_cast<float>(y)});
    }
    return samples;
}

/// A pixel's samples, taken again and again.
struct Samples {
    int n;
    std::vector<std::vector<Sample>> pixels;
};

inline Samples manySamples(int n) {
    constexpr int times = 500;
    Samples samples{n, {}};
    for (int i = 0; i < times; ++i) {
        sw::seedPixel(7, i, n);
        samples.pixels.push_back(samplesOf(i % pictureSize, i / 2 % pictureSize, n));
    }
    return samples;
}

/// A coordinate within its cell, in parts of the cell.
inline float inCell(float coordinate, int n) {
    const float cells = coordinate * static_cast<float>(n);
    return cells - std::floor(cells);
}

/// The fraction of all samples for which `is` holds.
template <typename Is>
float share(const Samples& samples, Is is) {
    float yes = 0, all = 0;
    for (const auto& pixel : samples.pixels)
        for (const Sample& s : pixel) ++all, yes += is(s) ? 1.f : 0.f;
    return all > 0 ? yes / all : 0;
}

}  // namespace lab
