#include <algorithm>

#include "support.h"
#include "swRayCount.h"
#include "swSampling.h"
#include "testScenes.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

constexpr int size = 4;  // pixels per side of the picture

// Looks along -z. With 90 degrees the picture is 2 x 2 at distance 1.
Camera frontCamera() {
    Camera camera(Vec3(0, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0), 90, 1);
    camera.setup(size, size);
    return camera;
}

struct Point {
    double x, y;
};

// Where in the picture a ray of that camera passes.
Point inPicture(const Ray& ray) {
    const dvec3 d = toDouble(ray.dir);
    return {size / 2 * (1 - d.x / d.z), size / 2 * (1 + d.y / d.z)};
}

// The sample points of pixel (x, y), from its top left corner.
std::vector<Point> samplePoints(int x, int y, int n) {
    const auto rays = std::make_shared<Recorder>();
    Scene scene;
    scene.push(rays);
    lab::samplePixel(static_cast<float>(x), static_cast<float>(y), n, 3, frontCamera(), scene);
    std::vector<Point> points;
    for (const Ray& ray : rays->rays) {
        const Point p = inPicture(ray);
        points.push_back({p.x - x, p.y - y});
    }
    return points;
}

// Which of n equal parts of [0, 1) a number lies in.
int part(double x, int n) {
    return static_cast<int>(std::floor(x * n));
}

}  // namespace

TEST_CASE("a single sample goes through the pixel's centre") {
    const int x = GENERATE(range(0, size)), y = GENERATE(range(0, size));
    seedPixel(GENERATE(1u, 2u, 3u), x, y);
    const auto points = samplePoints(x, y, 1);
    REQUIRE(points.size() == 1);
    CHECK(std::fabs(points[0].x - 0.5) < 2e-6);
    CHECK(std::fabs(points[0].y - 0.5) < 2e-6);
}

TEST_CASE("every cell of the grid holds one sample") {
    const int n = GENERATE(2, 3, 4, 5, 8, 16);
    const auto seed = GENERATE(range(0u, 10u));
    const int x = GENERATE(0, 1, 3), y = GENERATE(0, 2, 3);
    CAPTURE(n, seed, x, y);
    seedPixel(seed, x, y);
    takeRayCount();
    const auto points = samplePoints(x, y, n);
    CHECK(takeRayCount()[RayKind::primary] == static_cast<unsigned>(n * n));
    std::vector<int> samples(static_cast<unsigned>(n * n), 0);
    for (const Point& p : points) {
        const int column = part(p.x, n), row = part(p.y, n);
        REQUIRE((column >= 0 && column < n && row >= 0 && row < n));
        ++samples[static_cast<unsigned>(row * n + column)];
    }
    CHECK(std::count(samples.begin(), samples.end(), 1) == n * n);
}

TEST_CASE("samples fall evenly on all of the pixel") {
    const int n = GENERATE(2, 3, 5);
    // A finer grid of k x k parts in every cell, and the samples of many seeds in each of them.
    constexpr int k = 4, perPart = 100;
    const int parts = n * k;
    std::vector<int> samples(static_cast<unsigned>(parts * parts), 0);
    for (unsigned seed = 0; seed < perPart * k * k; ++seed) {
        seedPixel(seed, 1, 2);
        for (const Point& p : samplePoints(1, 2, n)) {
            const int column = std::clamp(part(p.x, parts), 0, parts - 1);
            const int row = std::clamp(part(p.y, parts), 0, parts - 1);
            ++samples[static_cast<unsigned>(row * parts + column)];
        }
    }
    // Binomial with mean 100 and deviation 9.7: six deviations either way.
    const auto [fewest, most] = std::minmax_element(samples.begin(), samples.end());
    CAPTURE(n);
    CHECK(*fewest > perPart - 60);
    CHECK(*most < perPart + 60);
}

TEST_CASE("samples reach the edges of the pixel but not beyond") {
    Point least{1, 1}, greatest{0, 0};
    for (unsigned seed = 0; seed < 1000; ++seed) {
        seedPixel(seed, 0, 0);
        for (const Point& p : samplePoints(0, 0, 2)) {
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
        }
    }
    for (const double low : {least.x, least.y}) CHECK((low > -2e-6 && low < 0.01));
    for (const double high : {greatest.x, greatest.y}) CHECK((high > 0.99 && high < 1 + 2e-6));
}

TEST_CASE("the mean of a constant is the constant") {
    const int n = GENERATE(1, 2, 3, 4, 7, 16);
    const Color sky(0.3f, 0.7f, 5);
    Scene scene;
    scene.setBackground(sky);
    seedPixel(1, 2, 3);
    CAPTURE(n);
    CHECK(distance(lab::samplePixel(2, 3, n, 3, frontCamera(), scene), sky) <= (n * n + 2) * u * 5);
}

TEST_CASE("all cells weigh the same") {
    const int n = GENERATE(2, 4, 6, 16);
    const bool upper = GENERATE(false, true);
    // Pixel (2, 1) shows x = 0 .. 0.5 and y = 0.5 .. 0 at z = -1; something unlit hides half of it.
    const Vec3 across[] = {Vec3(-90, 0.25f, -1), Vec3(90, 0.25f, -1), Vec3(0.25f, 90, -1)};
    const Vec3 upright[] = {Vec3(0.25f, -90, -1), Vec3(0.25f, 90, -1), Vec3(90, 0.25f, -1)};
    Scene scene;
    scene.setBackground(Color(1, 2, 4));
    scene.push(Triangle(upper ? across : upright, Material(Color(1, 1, 1))));
    for (unsigned seed = 0; seed < 50; ++seed) {
        seedPixel(seed, 2, 1);
        const Color mean = lab::samplePixel(2, 1, n, 3, frontCamera(), scene);
        CAPTURE(n, seed);
        CHECK(distance(mean, dvec3(0.5, 1, 2)) < 1e-5);
    }
}

TEST_CASE("the same seed gives the same samples and another gives others") {
    const int n = GENERATE(2, 3);
    const auto samplesOf = [n](unsigned seed, int x, int y) {
        seedPixel(seed, x, y);
        return samplePoints(0, 0, n);
    };
    const auto same = [](const std::vector<Point>& a, const std::vector<Point>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
    };
    const auto first = samplesOf(1, 2, 3);
    CHECK(same(first, samplesOf(1, 2, 3)));
    CHECK_FALSE(same(first, samplesOf(2, 2, 3)));
    CHECK_FALSE(same(first, samplesOf(1, 3, 3)));
    CHECK_FALSE(same(first, samplesOf(1, 3, 2)));
}

TEST_CASE("the depth is handed on to every sample") {
    const int depth = GENERATE(range(0, 4));
    const int n = GENERATE(1, 3);
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 5, Material(Color(1, 1, 1), 1)));
    seedPixel(1, 0, 0);
    takeRayCount();
    lab::samplePixel(0, 0, n, depth, frontCamera(), scene);
    CHECK(takeRayCount()[RayKind::reflected] == static_cast<unsigned>(n * n * depth));
}
