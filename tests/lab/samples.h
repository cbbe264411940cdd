#pragma once

#include <algorithm>
#include <array>
#include <set>

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

/// What the student's samplePixel() did for one pixel.
struct Pixel {
    int x, y;
    sw::Color color;
    std::vector<sw::Ray> rays;     ///< all that the scene was asked about, in order
    std::vector<sw::Ray> primary;  ///< those from the eye into the picture, each once
    std::vector<Sample> samples;   ///< where these meet the picture
    int lost = 0;                  ///< rays without a direction: NaN
    bool endless = false;
};

/// Sorts out rays. Whatever traceRay() does with a sample's ray, asks twice or sends on others, the
/// sample counts once.
inline void findSamples(Pixel& pixel) {
    constexpr float half = pictureSize / 2;
    std::set<std::array<float, 3>> known;
    for (const sw::Ray& ray : pixel.rays) {
        const sw::Vec3 d = ray.dir;
        if (!isNumber(d)) {
            ++pixel.lost;
            continue;
        }
        if (!ray.orig.isZero() || !(d[2] < 0) || !known.insert({d[0], d[1], d[2]}).second) continue;
        pixel.primary.emplace_back(ray.orig, d, ray.minT);
        pixel.samples.push_back({half * (1 - d[0] / d[2]) - static_cast<float>(pixel.x),
                                 half * (1 + d[1] / d[2]) - static_cast<float>(pixel.y)});
    }
}

/// More rays than a pixel needs of a program that traces each of its samples n * n times, and asks
/// the scene about each several times.
inline int noEnd(int n) {
    return 1000 + 4 * n * n * n * n;
}

/// Asks the student's samplePixel() for the pixel whose corner is (x, y).
/// @param mostRays  0: noEnd(n)
inline Pixel pixelOf(sw::Scene scene, int x, int y, int n, int depth = 3, int mostRays = 0) {
    const auto witness = std::make_shared<RayWitness>(mostRays > 0 ? mostRays : noEnd(n));
    scene.push(witness);
    Pixel pixel{x, y, {}, {}, {}, {}};
    try {
        pixel.color = samplePixel(static_cast<float>(x), static_cast<float>(y), n, depth,
                                  frontCamera(), scene);
    } catch (const TooManyRays&) {
        pixel.endless = true;
    }
    pixel.rays = witness->rays;
    findSamples(pixel);
    return pixel;
}

/// Nothing but a sky of that colour.
inline sw::Scene skyScene(const sw::Color& color = sky) {
    sw::Scene scene;
    scene.setBackground(color);
    return scene;
}

/// How many rays the student's own traceRay() needs for one ray.
/// @throws TooManyRays
inline std::size_t raysFor(sw::Scene scene, const sw::Ray& ray, int depth, int mostRays = 1000) {
    const auto witness = std::make_shared<RayWitness>(mostRays);
    scene.push(witness);
    traceRay(ray, scene, depth);
    return witness->rays.size();
}

/// Pixels, each with the random numbers of a seed of its own.
struct Samples {
    int n;
    std::vector<Pixel> pixels;
    std::vector<std::vector<float>> numbers;  ///< what uniform() gave for each pixel
};

inline Samples manySamples(int n, int times = 500) {
    Samples samples{n, {}, {}};
    for (int i = 0; i < times; ++i) {
        sw::seedPixel(7, i, n);
        auto& numbers = samples.numbers.emplace_back();
        for (int k = 0; k < 3 * n * n + 3; ++k) numbers.push_back(sw::uniform());
        sw::seedPixel(7, i, n);
        samples.pixels.push_back(pixelOf(skyScene(), i % pictureSize, i / 3 % pictureSize, n));
        if (samples.pixels.back().endless) break;
    }
    return samples;
}

/// Whether `is` holds for all samples.
template <typename Is>
bool all(const Samples& samples, Is is) {
    return std::all_of(samples.pixels.begin(), samples.pixels.end(), [&](const Pixel& pixel) {
        return std::all_of(pixel.samples.begin(), pixel.samples.end(), is);
    });
}

/// A coordinate within its cell, in parts of the cell.
inline float inCell(float coordinate, int n) {
    const float cells = coordinate * static_cast<float>(n);
    return cells - std::floor(cells);
}

}  // namespace lab
