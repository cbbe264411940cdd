#include "swStop.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "support.h"
#include "swRenderer.h"
#include "swScene.h"

using namespace sw;
using namespace test;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// A ray that hits a mirror.
Intersection onMirror() {
    Intersection hit;
    hit.normal = Vec3(0, 0, 1);
    hit.ray = Ray(Vec3(0, 0, 1), Vec3(0, 0, -1));
    hit.positionError = 0;
    return hit;
}

// As traceRay() between two mirrors, if the depth never ended.
Color endless(const Intersection& hit) {
    Intersection next = hit;
    while (true) next.ray = next.getReflectedRay();
}

}  // namespace

TEST_CASE("a render that is told to stop ends within a pixel, on every thread") {
    const auto threads = GENERATE(1, 2, 5);
    const auto start = Clock::now();
    RenderOptions options;
    options.threads = threads;
    options.tileSize = 4;
    options.stop = [&](int, int) { return secondsSince(start) > 0.05; };
    const auto radiance = [](int x, int) { return x == 7 ? endless(onMirror()) : Color(1, 1, 1); };
    const RenderResult result = render({0, 0, 40, 40}, radiance, options);
    CHECK_FALSE(result.complete);
    CHECK(secondsSince(start) < 5);
    // The next one is not concerned.
    options.stop = nullptr;
    CHECK(render({0, 0, 4, 4}, radiance, options).complete);
}

TEST_CASE("a render that nobody stops is asked about its own pixels and is complete") {
    std::atomic<int> asked{0}, wrong{0};
    RenderOptions options;
    options.threads = 3;
    options.stop = [&](int x, int y) {
        ++asked;
        if (x < 10 || x >= 70 || y < 20 || y >= 50) ++wrong;
        return false;
    };
    const auto place = [](int x, int y) {
        return Color(static_cast<float>(x), static_cast<float>(y), 0);
    };
    const RenderResult result = render({10, 20, 70, 50}, place, options);
    CHECK(result.complete);
    CHECK(wrong == 0);
    CHECK((asked > 60 * 30 / 16 && asked < 60 * 30));
    CHECK(distance(result.image.at(59, 29), Vec3(69, 49, 0)) == 0);
}

TEST_CASE("a stop in a picture within a pixel ends that picture alone") {
    const StopQuestion always = [](int, int) { return true; };
    RenderOptions inner;
    inner.stop = always;
    int incomplete = 0;
    const auto radiance = [&](int, int) {
        const auto black = [](int, int) { return Color(); };
        incomplete += !render({0, 0, 2, 2}, black, inner).complete;
        for (int i = 0; i < 1000; ++i) onMirror().getReflectedRay();
        return Color();
    };
    RenderOptions outer;
    outer.threads = 1;
    CHECK(render({0, 0, 5, 5}, radiance, outer).complete);
    CHECK(incomplete == 25);
}

TEST_CASE("short rays end after some generations, and others do not") {
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 100, Material()));  // whatever starts inside hits it
    Intersection hit = onMirror(), found;
    const bool isCut = GENERATE(false, true);
    std::optional<ShortRays> cut;
    if (isCut) cut.emplace();
    for (int i = 1; i <= ShortRays::generations + 1; ++i) {
        hit.ray = hit.getReflectedRay();
        CAPTURE(i, isCut);
        CHECK((hit.ray.maxT > 1e38f || hit.ray.maxT < 0));
        CHECK(scene.intersect(hit.ray, found) == (!isCut || i <= ShortRays::generations));
    }
}

TEST_CASE("a preview shows every pixel once, with its final colour, to one thread at a time") {
    const Window window{3, 5, 60, 41};
    std::vector<int> seen(57 * 36);
    std::atomic<int> inside{0}, wrong{0};
    RenderOptions options;
    options.threads = 4;
    options.tileSize = 7;
    options.preview = [&](const Window& tile, const ColorAt& colors) {
        if (++inside != 1) ++wrong;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                ++seen[static_cast<std::size_t>((y - 5) * 57 + x - 3)];
                if (colors(x, y)[0] != static_cast<float>(x + 100 * y)) ++wrong;
            }
        --inside;
    };
    render(
        window, [](int x, int y) { return Color(static_cast<float>(x + 100 * y), 0, 0); }, options);
    CHECK(wrong == 0);
    CHECK(std::count(seen.begin(), seen.end(), 1) == 57 * 36);
}
