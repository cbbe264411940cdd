#include "swErrorEstimate.h"

#include <limits>
#include <thread>

#include "support.h"
#include "swCorners.h"
#include "swMetrics.h"
#include "swSampling.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

bool isNone(const Color& error) {
    return std::isnan(error[0]) && std::isnan(error[1]) && std::isnan(error[2]);
}

// The error of the mean of these samples, as if it were 0.5.
Color errorOf(const std::vector<Color>& colors, SamplePattern pattern, int n) {
    PixelSamples samples(pattern, n);
    SampleMean mean;
    for (const Color& color : colors) mean += color;
    return samples.takeError(Color(0.5f, 0.5f, 0.5f));
}

// Pixels with noise in them: n x n samples of random colour.
std::function<Color(int, int)> noisyPixels(int n) {
    return [n](int x, int) {
        SampleMean mean;
        for (int i = 0; i < n * n; ++i)
            mean += (x % 2 == 0 ? 1.f : 0.5f) * Color(uniform(), uniform(), 0.25f);
        return Color(mean);
    };
}

}  // namespace

TEST_CASE("equal samples have no error") {
    const auto pattern =
        GENERATE(SamplePattern::jitter, SamplePattern::random, SamplePattern::multiJitter);
    const int n = GENERATE(2, 3, 8, 256);
    const std::vector<Color> samples(static_cast<std::size_t>(n * n), Color(0.25f, 0.5f, 1));
    CHECK(errorOf(samples, pattern, n).norm() < 1e-6f);
}

TEST_CASE("there is an estimate only for exactly n x n samples, at least 2 x 2") {
    const auto pattern = GENERATE(SamplePattern::jitter, SamplePattern::random);
    const int n = GENERATE(-1, 0, 1, 2, 3);
    const auto count = GENERATE(range(0, 12));
    CAPTURE(n, count);
    const std::vector<Color> samples(static_cast<std::size_t>(count));
    CHECK(isNone(errorOf(samples, pattern, n)) == !(n >= 2 && count == n * n));
}

TEST_CASE("the estimate of independent samples is the textbook's") {
    const std::vector<Color> samples{{.1f, 0, 0}, {.2f, 0, .1f}, {.3f, .1f, .1f}, {.6f, .1f, 0}};
    // Variances 0.14 / 3, 0.01 / 3 and 0.01 / 3, over four samples.
    const dvec3 expected(std::sqrt(0.14 / 12), std::sqrt(0.01 / 12), std::sqrt(0.01 / 12));
    CHECK(distance(errorOf(samples, SamplePattern::random, 2), expected) < 1e-6);
}

TEST_CASE("a linear change from cell to cell is no error") {
    const int n = GENERATE(2, 3, 5, 8);
    const auto part = [n](int i) { return static_cast<float>(i) / static_cast<float>(n); };
    std::vector<Color> samples;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) samples.push_back(Color(part(i), part(j), part(2 * i - 3 * j)));
    CHECK(errorOf(samples, SamplePattern::jitter, n).norm() < 1e-6f);
    samples[1][1] += 0.5f;  // in one block of four cells, or in two
    const double blocks = n == 2 ? 1 : 2;
    const double expected = 0.5 * std::sqrt(0.742 / 4 * blocks / ((n - 1) * (n - 1))) / n;
    CHECK(std::fabs(errorOf(samples, SamplePattern::jitter, n)[1] - expected) < 1e-6);
}

TEST_CASE("the displayed error is limited by white and black") {
    const auto [mean, error, expected] =
        GENERATE(table<float, float, float>({{0.5f, 0.25f, 0.25f},
                                             {0.5f, 0, 0},
                                             {0.5f, 9, 0.5f},
                                             {1, 0.25f, 0.125f},
                                             {0, 0.25f, 0.125f},
                                             {1.25f, 0.125f, 0},
                                             {1.25f, 0.5f, 0.125f},
                                             {-1, 0.5f, 0},
                                             {infinity, 1, 0},
                                             {infinity, infinity, 0.5f},
                                             {0.5f, NAN, 0.5f},
                                             {NAN, 0.25f, 0.5f}}));
    CAPTURE(mean, error);
    CHECK(displayedError(mean, error) == expected);
}

TEST_CASE("samples are recorded for the innermost picture of their own thread") {
    const Color red(1, 0, 0), none(0, 0, 0);
    const auto take = [](const Color& color) { return Color(SampleMean() += color); };
    CHECK(isSame(take(red), red));  // no PixelSamples exists
    PixelSamples outer(SamplePattern::random, 2);
    take(red);
    {
        PixelSamples inner(SamplePattern::jitter, 2);
        CHECK(isNone(inner.takeError(none)));
        for (int i = 0; i < 4; ++i) take(none);
        CHECK(isSame(inner.takeError(none), none));
        CHECK(isNone(inner.takeError(none)));  // forgotten
    }
    std::thread([&] { take(red); }).join();
    for (int i = 0; i < 3; ++i) take(none);
    CHECK(std::fabs(outer.takeError(Color(0.5f, 0.5f, 0.5f))[0] - 0.25f) < 1e-6f);
}

TEST_CASE("the picture's error is the root mean square of its pixels'") {
    const int n = GENERATE(2, 3, 5);
    const Window window{0, 0, 40, 25};
    const RenderResult picture = render(window, noisyPixels(n), {.samples = n});
    double squares = 0;
    for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 40; ++x) {
            const dvec3 e = toDouble(picture.errors.at(x, y));
            squares += dot(e, e);
            CHECK(e.z < 1e-7);
        }
    CHECK(std::fabs(picture.estimatedRmse - std::sqrt(squares / 3000)) < 1e-6);
    CHECK(picture.estimatedRmse > 0.02);
}

TEST_CASE("errors are the same for any threads, tiles and crop") {
    const Window all{0, 0, 50, 40}, part{7, 3, 30, 33};
    const RenderResult expected = render(all, noisyPixels(4), {.threads = 1, .samples = 4});
    const int threads = GENERATE(1, 2, 5);
    CHECK(render(all, noisyPixels(4), {.threads = threads, .samples = 4}).estimatedRmse ==
          expected.estimatedRmse);
    const RenderResult cropped =
        render(part, noisyPixels(4), {.tileSize = 5, .threads = threads, .samples = 4});
    int wrong = 0;
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x)
            wrong += !isSame(cropped.errors.at(x - 7, y - 3), expected.errors.at(x, y));
    CHECK(wrong == 0);
}

TEST_CASE("pictures have an estimate only with four or more recorded samples per pixel") {
    const auto [noted, told] = GENERATE(table<int, int>({{0, 2}, {1, 1}, {2, 0}, {2, 3}}));
    CAPTURE(noted, told);
    const RenderResult picture = render({0, 0, 9, 9}, noisyPixels(noted), {.samples = told});
    CHECK(std::isnan(picture.estimatedRmse));
    CHECK(isNone(picture.errors.at(3, 3)));
    CHECK(std::isnan(estimatedRmse8bit(picture.image, picture.errors)));
}

TEST_CASE("a picture made of corners has no estimate") {
    const Window window{0, 0, 9, 9};
    const RenderResult picture = renderCorners(window, noisyPixels(1), {.samples = 2});
    CHECK(std::isnan(picture.estimatedRmse));
    CHECK((isNone(picture.errors.at(0, 0)) && isNone(picture.errors.at(8, 8))));
}

TEST_CASE("the error in code values counts from the mean downwards") {
    Image image(1, 1), errors(1, 1);
    image.at(0, 0) = Color(0.25f, 0.0625f, 9);
    errors.at(0, 0) = Color(0.125f, 0.125f, 0.25f);
    const auto code = [](double v) { return 256 * std::pow(v, 1 / 1.8); };
    const double red = code(0.25) - code(0.125), green = code(0.0625), blue = 256 - code(0.75);
    CHECK(std::fabs(estimatedRmse8bit(image, errors, 1.8f) -
                    std::sqrt((red * red + green * green + blue * blue) / 3)) < 1e-3);
}

TEST_CASE("the lab's samplePixel records every sample") {
    const int n = GENERATE(2, 3, 5);
    Camera camera(Vec3(0, 0, 0), Vec3(0, 0, -1), Vec3(0, 1, 0), 90, 1);
    camera.setup(8, 8);
    Scene scene;
    scene.setBackground(Color(0.5f, 0.5f, 0.5f));
    PixelSamples samples(SamplePattern::jitter, n);
    CHECK(isSame(samples.takeError(lab::samplePixel(1, 2, n, 3, camera, scene)), Color(0, 0, 0)));
}
