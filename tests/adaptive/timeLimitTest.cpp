#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "support.h"
#include "swAdaptive.h"
#include "swIntersection.h"

using namespace sw;
using namespace test;

namespace {

using Radiance = std::function<Color(float, float)>;

AdaptiveOptions within(double seconds, int threads = 2) {
    AdaptiveOptions options;
    options.timeLimit = seconds;
    options.render.threads = threads;
    return options;
}

AdaptiveResult rendered(const Radiance& radiance, int size, const AdaptiveOptions& options) {
    return renderAdaptive({0, 0, size, size}, size, size, radiance, options);
}

void spend(double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < end) {
    }
}

Color slope(float x, float y) {
    return Color(0.1f + 0.002f * x, 0.1f + 0.002f * y, 0.5f);
}

// Rays that double at every level, as between two shells of glass.
Color doubling(const Intersection& hit, int depth) {
    if (depth == 0 || hit.ray.maxT < 0) return Color(0, 0, 1);
    Intersection next = hit;
    next.ray = hit.getReflectedRay();
    const Color one = doubling(next, depth - 1);
    next.ray = hit.getRefractedRay();
    return 0.5f * one + 0.5f * doubling(next, depth - 1);
}

Color forEver() {
    Intersection hit;
    hit.normal = Vec3(0, 0, 1);
    hit.ray = Ray(Vec3(0, 0, 1), Vec3(0, 0, -1));
    return doubling(hit, 60);
}

std::size_t zeros(const AdaptiveResult& result) {
    return static_cast<std::size_t>(
        std::count(result.sampleCounts.begin(), result.sampleCounts.end(), 0));
}

}  // namespace

TEST_CASE("the picture is whole however short the time", "[adaptive]") {
    const double limit = GENERATE(1e-9, 1e-4, 0.01, 0.1);
    const auto threads = GENERATE(1, 3);
    const auto slow = [](float x, float y) {
        spend(20e-6);
        return slope(x, y);
    };
    const AdaptiveResult result = rendered(slow, 300, within(limit, threads));
    CAPTURE(limit, threads, result.samples, result.roughPixels);
    CHECK(result.complete);
    CHECK(result.roughPixels == zeros(result));
    CHECK(result.roughPixels > 0);
    CHECK(result.seconds < limit + 2);  // tests share the machine
    // No pixel is farther from its true colour than 64 pixels of slope would be.
    double worst = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x)
            worst = std::max<double>(
                worst, distance(result.image.at(x, y),
                                slope(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)));
    CHECK(worst < 64 * 0.003);
    CHECK((result.estimatedRmse > 0 && result.estimatedRmse < 0.3));
}

TEST_CASE("more time leaves fewer rough pixels, and at last none", "[adaptive]") {
    const auto slow = [](float x, float y) {
        spend(5e-6);
        return slope(x, y);
    };
    const std::uint64_t few = rendered(slow, 200, within(0.02)).roughPixels;
    const AdaptiveResult enough = rendered(slow, 200, within(5));
    CHECK(few > enough.roughPixels);
    CHECK(enough.roughPixels == 0);
    CHECK(enough.passes >= 1);
}

TEST_CASE("a limit that is not reached changes no bit", "[adaptive]") {
    const auto busy = [](float x, float y) {
        return (x - 20) * (x - 20) + y * y < 300 ? Color(1, 0, 0) : slope(x, y);
    };
    AdaptiveOptions options;
    options.tolerance = 0.02f;
    const AdaptiveResult expected = rendered(busy, 50, options);
    options.timeLimit = 1000;
    const AdaptiveResult result = rendered(busy, 50, options);
    int wrong = 0;
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x)
            wrong += !isSame(result.image.at(x, y), expected.image.at(x, y));
    CHECK(wrong == 0);
    CHECK(result.sampleCounts == expected.sampleCounts);
}

TEST_CASE("pixels that take for ever are cut short, and the others are what they are",
          "[adaptive]") {
    const auto threads = GENERATE(1, 2);
    const auto radiance = [](float x, float y) { return x < 20 ? forEver() : slope(x, y); };
    const AdaptiveResult result = rendered(radiance, 40, within(1, threads));
    CAPTURE(threads, result.roughPixels, result.passes);
    CHECK(result.complete);
    CHECK(result.seconds < 2);
    CHECK(result.roughPixels >= 20 * 40);
    CHECK(result.roughPixels < 25 * 40);
    for (int y = 0; y < 40; ++y) {
        CHECK(result.image.at(10, y)[2] == 1);
        CHECK(result.image.at(10, y)[0] == 0);
        CHECK(distance(result.image.at(30, y), slope(30.5f, static_cast<float>(y) + 0.5f)) < 0.01);
    }
}

TEST_CASE("a stop before the first pass is done leaves pixels missing, later none", "[adaptive]") {
    std::atomic<int> samples{0};
    const auto counted = [&samples](float x, float y) {
        ++samples;
        return Color(x > 30 ? 1.f : y / 64, uniform(), 0);
    };
    const int after = GENERATE(0, 1000, 4000, 5000, 20000);
    AdaptiveOptions options;
    options.render.threads = GENERATE(1, 3);
    options.render.stop = [&](int, int) { return samples >= after; };
    const AdaptiveResult result = rendered(counted, 64, options);
    CAPTURE(after);
    CHECK(result.complete == (after > 64 * 64));
    CHECK(samples < after + 3 * 300);
    if (result.complete) CHECK(result.estimatedRmse > 0);
    if (result.complete) CHECK(result.roughPixels == 0);
}

TEST_CASE("with a time limit, a stop leaves the coarse picture", "[adaptive]") {
    std::atomic<int> samples{0};
    const auto counted = [&samples](float x, float y) {
        ++samples;
        return slope(x, y);
    };
    AdaptiveOptions options = within(1000);
    options.render.stop = [&](int, int) { return samples >= 500; };
    const AdaptiveResult result = rendered(counted, 64, options);
    CHECK(result.complete);
    CHECK(result.roughPixels > 0);
}

TEST_CASE("progress counts the tiles of every pass", "[adaptive]") {
    AdaptiveOptions options;
    options.tolerance = 0.01f;
    int last = 0, begun = 0, wrong = 0;
    options.render.progress = [&](int done, int total) {
        if (done == 1) ++begun;
        if (done != 1 && done != last + 1) ++wrong;
        last = done == total ? 0 : done;
    };
    const auto noise = [](float, float) { return Color(uniform(), uniform(), 0); };
    const AdaptiveResult result = rendered(noise, 32, options);
    CHECK(begun == result.passes);
    CHECK(wrong == 0);
    CHECK(last == 0);
}

TEST_CASE("the last preview of an adaptive picture is the picture", "[adaptive]") {
    const bool limited = GENERATE(false, true);
    AdaptiveOptions options;
    options.tolerance = 0.02f;
    if (limited) options.timeLimit = 1000;
    options.render.threads = 3;
    Image shown(40, 40);
    options.render.preview = [&](const Window& tile, const ColorAt& colors) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) shown.at(x, y) = colors(x, y);
    };
    const auto edge = [](float x, float y) {
        return x + 0.3f * y > 20 ? Color(1, 1, 1) : slope(x, y);
    };
    const AdaptiveResult result = rendered(edge, 40, options);
    int wrong = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) wrong += !isSame(shown.at(x, y), result.image.at(x, y));
    CHECK(wrong == 0);
}
