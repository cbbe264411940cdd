#include "edges.h"
#include "support.h"
#include "swErrorEstimate.h"
#include "swMetrics.h"
#include "swNff.h"
#include "swRenderer.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

// How much the estimate is too large over many pixels: the ratio of root mean squares.
template <typename Pixel>  // returns a function of the place and its exact mean
double calibration(SamplePattern pattern, int n, const Pixel& pixel, int pixels = 20000) {
    double estimated = 0, actual = 0;
    for (int i = 0; i < pixels; ++i) {
        const auto [gray, exact] = pixel();
        seedPixel(5, i, n);
        PixelSamples samples(pattern, n);
        const Color mean = samplePixelWith(pattern, 0, 0, n, [&g = gray](float x, float y) {
            const auto v = static_cast<float>(g(x, y));
            return Color(v, v, v);
        });
        const float error = samples.takeError(Color(0.5f, 0.5f, 0.5f))[1];
        estimated += static_cast<double>(error) * error;
        actual += (mean[1] - exact) * (mean[1] - exact);
    }
    return std::sqrt(estimated / actual);
}

}  // namespace

TEST_CASE("the error is right at edges of any direction") {
    const auto pattern =
        GENERATE(SamplePattern::jitter, SamplePattern::random, SamplePattern::multiJitter);
    const int n = GENERATE(2, 3, 4, 5, 8);
    Random random(3);
    const double ratio = calibration(pattern, n, [&] {
        const Edge edge = randomEdge(random);
        return std::pair(edge, edge.area());
    });
    CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n, ratio);
    CHECK(std::fabs(ratio - 1) < (pattern == SamplePattern::multiJitter ? 0.2 : 0.05));
}

TEST_CASE("the error is a little too small at upright edges and on smooth surfaces") {
    // There the contrast of four cells is right without the factor that edges need.
    const int n = GENERATE(2, 3, 4, 8);
    Random random(4);
    const double upright = calibration(SamplePattern::jitter, n, [&] {
        const double c = random.uniform(0, 1);
        return std::pair([c](float x, float) { return x > c ? 1.0 : 0.0; }, 1 - c);
    });
    const double smooth = calibration(SamplePattern::jitter, n, [&] {
        const double a = random.uniform(-0.5, 0.5), b = random.uniform(-0.5, 0.5);
        return std::pair([a, b](float x, float y) { return a * x + b * y; }, (a + b) / 2);
    });
    CAPTURE(n, upright, smooth);
    CHECK(std::fabs(upright - std::sqrt(0.742)) < 0.05);
    CHECK(std::fabs(smooth - std::sqrt(0.742)) < 0.05);
}

TEST_CASE("the error of the lab scene is estimated within a factor of 1.5") {
    constexpr int size = 32;
    const Window window{0, 0, size, size};
    NffScene file = loadNff(SW_SCENES "/cornell.nff");
    file.camera.setup(size, size);
    const auto radiance = [&](float x, float y) {
        return lab::traceRay(file.camera.getRay(x, y), file.scene, 3);
    };
    const auto pixelOf = [&](SamplePattern pattern, int n) {
        return [=](int x, int y) {
            return samplePixelWith(pattern, static_cast<float>(x), static_cast<float>(y), n,
                                   radiance);
        };
    };
    const Image reference = render(window, pixelOf(SamplePattern::jitter, 64), {.seed = 999}).image;

    const auto check = [&](SamplePattern pattern, int n) {
        double logCodeValues = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const RenderResult picture = render(window, pixelOf(pattern, n),
                                                {.seed = seed, .pattern = pattern, .samples = n});
            const Metrics actual = compare(picture.image, reference);
            const double ratio = picture.estimatedRmse / actual.rmse;
            CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n, seed, ratio);
            CHECK((ratio > 1 / 1.5 && ratio < 1.5));
            logCodeValues +=
                std::log(estimatedRmse8bit(picture.image, picture.errors) / actual.rmse8bit);
        }
        const double codeValues = std::exp(logCodeValues / 20);
        CAPTURE(patternNames[static_cast<std::size_t>(pattern)], n, codeValues);
        CHECK((codeValues > 1 / 1.5 && codeValues < 1.5));
    };
    for (const int n : {2, 3, 4, 8}) {
        check(SamplePattern::jitter, n);
        check(SamplePattern::multiJitter, n);
    }
}
