#include "swRenderer.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "support.h"
#include "swSampling.h"
#include "swScene.h"

using namespace sw;
using namespace test;

namespace {

const auto noise = [](int, int) { return Color(uniform(), uniform(), uniform()); };
const auto politeNoise = [](int, int) {
    const float red = uniform(), green = uniform();
    std::this_thread::yield();  // so that threads mix even on one core
    return Color(red, green, uniform());
};
const auto position = [](int x, int y) {
    return Color(static_cast<float>(x), static_cast<float>(y), 1);
};

RenderOptions with(int threads, int tileSize = 16, std::uint64_t seed = 1) {
    RenderOptions options;
    options.threads = threads;
    options.tileSize = tileSize;
    options.seed = seed;
    return options;
}

Image rendered(const Window& window, const std::function<Color(int, int)>& radiance,
               const RenderOptions& options = {}) {
    return render(window, radiance, options).image;
}

// Pixels of the window in which the part differs in any bit from the whole.
int differences(const Image& part, const Window& window, const Image& whole) {
    int count = 0;
    for (int y = 0; y < window.height(); ++y) {
        for (int x = 0; x < window.width(); ++x) {
            count += !isSame(part.at(x, y), whole.at(window.x0 + x, window.y0 + y));
        }
    }
    return count;
}

Window randomWindow(Random& random, int width, int height) {
    const int x0 = random.whole(0, width - 1), y0 = random.whole(0, height - 1);
    return {x0, y0, random.whole(x0 + 1, width), random.whole(y0 + 1, height)};
}

}  // namespace

TEST_CASE("every pixel is written once with its own colour") {
    const auto [width, height] =
        GENERATE(table<int, int>({{1, 1}, {1, 50}, {50, 1}, {16, 16}, {17, 33}, {100, 40}}));
    const auto threads = GENERATE(1, 2, 7);
    const auto tileSize = GENERATE(-1, 0, 1, 5, 16, 1000);
    CAPTURE(width, height, threads, tileSize);
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(width * height));
    const auto counted = [&, w = width](int x, int y) {
        ++visits[static_cast<std::size_t>(y * w + x)];
        return position(x, y);
    };
    const Image image = rendered({0, 0, width, height}, counted, with(threads, tileSize));
    int wrong = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (distance(image.at(x, y), position(x, y)) != 0) ++wrong;
    for (const auto& n : visits) wrong += n != 1;
    CHECK(wrong == 0);
}

TEST_CASE("the picture is the same for any threads and tiles") {
    const Window window{0, 0, 70, 45};
    const Image expected = rendered(window, politeNoise, with(1));
    const auto threads = GENERATE(0, 1, 2, 5, 100);
    const auto tileSize = GENERATE(1, 3, 16, 64);
    CAPTURE(threads, tileSize);
    const Image image = rendered(window, politeNoise, with(threads, tileSize));
    CHECK(differences(image, window, expected) == 0);
}

TEST_CASE("a window holds the same pixels as the whole picture") {
    const Window all{0, 0, 60, 50};
    Random random(GENERATE(range(0u, 50u)));
    const Window window = randomWindow(random, 60, 50);
    CAPTURE(window.x0, window.y0, window.x1, window.y1);
    CHECK(differences(rendered(window, position), window, rendered(all, position)) == 0);
    CHECK(differences(rendered(window, noise), window, rendered(all, noise)) == 0);
}

TEST_CASE("another seed gives other random numbers and the same one the same") {
    const Window window{0, 0, 20, 20};
    const Image image = rendered(window, noise, with(0, 16, 7));
    CHECK(differences(image, window, rendered(window, noise, with(0, 16, 7))) == 0);
    CHECK(differences(image, window, rendered(window, noise, with(0, 16, 8))) == 400);
    CHECK(differences(image, window, rendered(window, noise)) == 400);
}

TEST_CASE("progress counts every tile from one to the total") {
    const auto threads = GENERATE(1, 4);
    const auto tileSize = GENERATE(1, 8, 16, 100);
    CAPTURE(threads, tileSize);
    const int total = ((50 + tileSize - 1) / tileSize) * ((30 + tileSize - 1) / tileSize);
    std::mutex busy;
    int last = 0, wrong = 0;
    const auto progress = [&](int done, int of) {
        const std::unique_lock alone(busy, std::try_to_lock);
        if (!alone || done != last + 1 || of != total) ++wrong;
        last = done;
        std::this_thread::sleep_for(std::chrono::microseconds(20));
    };
    RenderOptions options = with(threads, tileSize);
    options.progress = progress;
    rendered({0, 0, 50, 30}, position, options);
    CHECK(wrong == 0);
    CHECK(last == total);
}

TEST_CASE("an exception from a pixel ends the rendering and is passed on") {
    const auto threads = GENERATE(1, 2, 8);
    CAPTURE(threads);
    std::atomic<bool> failed = false;
    std::atomic<int> callsAfter = 0;
    const auto fails = [&](int x, int y) {
        if (x == 37 && y == 5) {
            failed = true;
            throw std::domain_error("pixel 37, 5");
        }
        if (failed) {
            ++callsAfter;
            std::this_thread::sleep_for(std::chrono::microseconds(50));
        }
        return position(x, y);
    };
    std::string message;
    try {
        rendered({0, 0, 200, 200}, fails, with(threads));
    } catch (const std::domain_error& error) {
        message = error.what();
    }
    CHECK(message == "pixel 37, 5");
    // Other threads finish their tile and take no more.
    CHECK(callsAfter < 200 * 200 / 2);
    // The next picture is not affected.
    const Window window{0, 0, 20, 20};
    CHECK(differences(rendered(window, position), window, rendered(window, position)) == 0);
}

TEST_CASE("only one of many exceptions from pixels and progress is passed on") {
    const auto threads = GENERATE(1, 3);
    CAPTURE(threads);
    const auto fails = [](int, int) -> Color { throw std::range_error("any"); };
    CHECK_THROWS_AS(rendered({0, 0, 100, 100}, fails, with(threads)), std::range_error);
    RenderOptions options = with(threads);
    options.progress = [](int, int) { throw std::length_error("stop"); };
    CHECK_THROWS_AS(rendered({0, 0, 100, 100}, position, options), std::length_error);
}

TEST_CASE("statistics count every ray of every thread exactly once") {
    const auto threads = GENERATE(1, 2, 5);
    CAPTURE(threads);
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, -5), 1, Material()));
    const Ray before(Vec3(0, 0, 0), Vec3(0, 0, -1), 0, FLT_MAX, RayKind::primary);
    Intersection hit;
    for (int i = 0; i < 3; ++i) scene.intersect(before, hit);

    // Half of the pixels see the sphere. Each sends x % 3 shadow rays and one of its own.
    const auto radiance = [&scene](int x, int y) {
        const Vec3 direction(0, 0, y % 2 == 0 ? -1.0f : 1.0f);
        Intersection found;
        scene.intersect(Ray({}, direction, 0, FLT_MAX, RayKind::primary), found);
        for (int i = 0; i < x % 3; ++i)
            scene.intersect(Ray({}, direction, 0, 1, RayKind::shadow), found, true);
        scene.intersect(Ray({}, direction), found);
        return Color();
    };
    const RenderResult result = render({0, 0, 60, 40}, radiance, with(threads));
    CHECK(result.rays[RayKind::primary] == 60 * 40);
    CHECK(result.rays.hitsOf(RayKind::primary) == 60 * 20);
    CHECK(result.rays[RayKind::shadow] == 60 * 40);
    CHECK(result.rays[RayKind::other] == 60 * 40);
    CHECK(result.rays[RayKind::reflected] == 0);
    CHECK(result.rays[RayKind::refracted] == 0);
    CHECK(result.rays.total() == 3 * 60 * 40);
}

TEST_CASE("statistics hold the threads that took part and the wall time") {
    const auto slow = [](int, int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return Color();
    };
    const RenderResult result = render({0, 0, 4, 1}, slow, with(4, 1));
    CHECK(result.threads == 4);
    CHECK(result.seconds >= 0.02);
    // A picture of one tile gives one thread something to do.
    CHECK(render({0, 0, 4, 1}, position, with(4)).threads == 1);
}

TEST_CASE("several threads work at the same time") {
    std::mutex mutex;
    std::set<std::thread::id> workers;
    std::atomic<int> waiting = 2;
    const auto meet = [&](int, int) {
        {
            const std::lock_guard lock(mutex);
            workers.insert(std::this_thread::get_id());
        }
        --waiting;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (waiting > 0 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        return Color();
    };
    rendered({0, 0, 2, 1}, meet, with(2, 1));
    CHECK(workers.size() == 2);
}
