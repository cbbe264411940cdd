#include "swSamplePattern.h"

#include <algorithm>
#include <vector>

#include "edges.h"
#include "support.h"
#include "swSampling.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

std::vector<SamplePoint> pointsOf(SamplePattern pattern, int n, std::uint64_t seed) {
    seedPixel(seed, 3, 4);
    return samplePoints(pattern, n);
}

// Which of so many equal parts of 0..1 a number lies in.
int part(float x, int parts) {
    return static_cast<int>(x * static_cast<float>(parts));
}

// How many of the numbers 0 .. parts-1 occur.
int different(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return static_cast<int>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

}  // namespace

TEST_CASE("every pattern takes n x n samples within the pixel") {
    const auto pattern = GENERATE(SamplePattern::jitter, SamplePattern::grid, SamplePattern::random,
                                  SamplePattern::multiJitter);
    const int n = GENERATE(1, 2, 3, 4, 5, 6, 7, 8, 16, 64);
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n);
    const auto points = pointsOf(pattern, n, 1);
    CHECK(points.size() == static_cast<std::size_t>(n * n));
    for (const SamplePoint& p : points) REQUIRE((p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1));
}

TEST_CASE("one sample lies in every cell, row by row") {
    const auto pattern =
        GENERATE(SamplePattern::jitter, SamplePattern::grid, SamplePattern::multiJitter);
    const int n = GENERATE(range(1, 17));
    const auto seed = GENERATE(range(0u, 10u));
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n, seed);
    int next = 0;
    for (const SamplePoint& p : pointsOf(pattern, n, seed))
        CHECK(part(p.y, n) * n + part(p.x, n) == next++);
}

TEST_CASE("multi-jitter has a sample in every narrow column and in every narrow row") {
    const int n = GENERATE(range(2, 17));
    const auto seed = GENERATE(range(0u, 10u));
    CAPTURE(n, seed);
    std::vector<int> columns, rows;
    for (const SamplePoint& p : pointsOf(SamplePattern::multiJitter, n, seed)) {
        columns.push_back(part(p.x, n * n));
        rows.push_back(part(p.y, n * n));
    }
    CHECK(different(columns) == n * n);
    CHECK(different(rows) == n * n);
}

TEST_CASE("a grid is made of the centres of its cells") {
    const int n = GENERATE(1, 2, 5, 8);
    int i = 0;
    for (const SamplePoint& p : pointsOf(SamplePattern::grid, n, 1)) {
        CHECK(std::fabs(p.x - (i % n + 0.5) / n) <= u);
        CHECK(std::fabs(p.y - (i / n + 0.5) / n) <= u);
        ++i;
    }
}

TEST_CASE("a single sample is the pixel's centre, except with random") {
    const auto pattern = GENERATE(SamplePattern::jitter, SamplePattern::grid, SamplePattern::random,
                                  SamplePattern::multiJitter);
    const SamplePoint p = pointsOf(pattern, 1, 1).front();
    CHECK((p.x == 0.5f && p.y == 0.5f) == (pattern != SamplePattern::random));
}

TEST_CASE("samples are uniform over the pixel") {
    const auto pattern =
        GENERATE(SamplePattern::jitter, SamplePattern::random, SamplePattern::multiJitter);
    const int n = GENERATE(2, 3, 5);
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n);
    // The samples of many seeds in k x k parts of every cell: binomial with mean 100.
    constexpr int k = 4, perPart = 100;
    const int parts = n * k;
    std::vector<int> samples(static_cast<unsigned>(parts * parts), 0);
    for (unsigned seed = 0; seed < perPart * k * k; ++seed)
        for (const SamplePoint& p : pointsOf(pattern, n, seed))
            ++samples[static_cast<unsigned>(part(p.y, parts) * parts + part(p.x, parts))];
    const auto [fewest, most] = std::minmax_element(samples.begin(), samples.end());
    CHECK(*fewest > perPart - 60);  // six deviations
    CHECK(*most < perPart + 60);
}

TEST_CASE("samples depend on seed and pixel, and on nothing else") {
    const auto pattern =
        GENERATE(SamplePattern::jitter, SamplePattern::random, SamplePattern::multiJitter);
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)]);
    const auto same = [](const std::vector<SamplePoint>& a, const std::vector<SamplePoint>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [](auto& p, auto& q) { return p.x == q.x && p.y == q.y; });
    };
    const auto first = pointsOf(pattern, 4, 1);
    CHECK(same(first, pointsOf(pattern, 4, 1)));
    CHECK_FALSE(same(first, pointsOf(pattern, 4, 2)));
    seedPixel(1, 4, 3);
    CHECK_FALSE(same(first, samplePoints(pattern, 4)));
}

TEST_CASE("jitter gives the picture of the lab's samplePixel to the last bit") {
    const int n = GENERATE(1, 2, 3, 7);
    const auto seed = GENERATE(range(0u, 5u));
    Camera camera(Vec3(0, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0), 90, 1);
    camera.setup(8, 8);
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, -4), 3, Material(Color(1, 0.5f, 0.3f))));
    scene.push(Light(Vec3(3, 2, 1)));
    seedPixel(seed, 5, 6);
    const Color expected = lab::samplePixel(5, 6, n, 3, camera, scene);
    seedPixel(seed, 5, 6);
    const Color color = samplePixelWith(SamplePattern::jitter, 5, 6, n, [&](float x, float y) {
        return lab::traceRay(camera.getRay(x, y), scene, 3);
    });
    CAPTURE(n, seed, expected, color);
    CHECK(expected.norm() > 0);
    CHECK(distance(expected, color) == 0);
}

TEST_CASE("errors at edges fall as theory predicts") {
    // Independent samples: variance p (1 - p) / N. Jitter: an edge cuts some sqrt(N) of the N
    // cells, so that the variance of the mean is like sqrt(N) / N^2 (Mitchell, Consequences of
    // Stratified Sampling in Graphics, 1996).
    const auto [pattern, expected] = GENERATE(table<SamplePattern, double>(
        {{SamplePattern::random, -0.5}, {SamplePattern::jitter, -0.75}}));
    const double slope = fittedSlope(pattern, {2, 3, 4, 6, 8, 12, 16});
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)], slope);
    CHECK(std::fabs(slope - expected) < 0.1);
}

TEST_CASE("multi-jitter errs less than jitter at edges, and jitter less than random") {
    const int n = GENERATE(2, 3, 4, 5, 8);
    const double random = edgeRmse(SamplePattern::random, n),
                 jitter = edgeRmse(SamplePattern::jitter, n),
                 multiJitter = edgeRmse(SamplePattern::multiJitter, n);
    CAPTURE(n, random, jitter, multiJitter);
    CHECK(jitter < 0.8 * random);
    CHECK(multiJitter < 0.9 * jitter);
}
