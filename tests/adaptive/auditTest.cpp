// The audit: what independent samples say about a picture's error.
#include "adaptive/audit.h"

#include <cmath>

#include "adaptive/auditedPixel.h"
#include "support.h"
#include "swAdaptive.h"
#include "swMetrics.h"
#include "swSampling.h"

using namespace sw;
using namespace test;

namespace {

Color grey(float value) {
    return {value, value, value};
}

constexpr int size = 128;
const Window whole{0, 0, size, size};

// Black, but for a square at a random place in some of the pixels.
struct Dots {
    float side;    // of a square, in pixels
    double share;  // of the pixels that have one
    float brightness = 1;

    // Where the pixel's square begins; none: beyond its end.
    Vec3 placeIn(int x, int y) const {
        Random random(static_cast<unsigned>(1 + x + 1000 * y));
        if (random.uniform(0, 1) >= share) return {2, 2, 0};
        return {random.real(0, 1 - side), random.real(0, 1 - side), 0};
    }
    Color operator()(float x, float y) const {
        const int column = static_cast<int>(x), row = static_cast<int>(y);
        const Vec3 place = placeIn(column, row);
        const float u = x - static_cast<float>(column) - place[0];
        const float v = y - static_cast<float>(row) - place[1];
        return grey(u >= 0 && u < side && v >= 0 && v < side ? brightness : 0);
    }
    Image exact() const {
        Image image(size, size);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (placeIn(x, y)[0] < 1) image.at(x, y) = grey(side * side * brightness);
        return image;
    }
};

AdaptiveResult rendered(const std::function<Color(float, float)>& radiance, float tolerance,
                        float target, unsigned seed) {
    AdaptiveOptions options;
    options.tolerance = tolerance;
    options.targetRmse = target;
    options.render.seed = seed;
    return renderAdaptive(whole, size, size, radiance, options);
}

double squared(double v) {
    return v * v;
}

}  // namespace

TEST_CASE("the mean product of a sample and a mean is the squared error, whatever was seen") {
    const float coverage = GENERATE(0.02f, 0.1f, 0.5f), contrast = GENERATE(0.5f, -0.5f, 0.3f);
    const float shown = GENERATE(0.f, 0.2f, 1.f);
    CAPTURE(coverage, contrast, shown);
    Random random(1);
    // A pixel of two colours, 0.5 and 0.5 + contrast.
    const auto sample = [&] { return 0.5f + (random.real(0, 1) < coverage ? contrast : 0); };
    const double mean = 0.5 + static_cast<double>(coverage) * static_cast<double>(contrast);
    double sum = 0, squares = 0;
    constexpr int trials = 200000;
    for (int i = 0; i < trials; ++i) {
        const float a = sample(), b = sample();
        const double product = static_cast<double>(productOf(grey(a), grey(b), grey(shown)));
        sum += product;
        squares += product * product;
    }
    const double error = std::sqrt(squares / trials / trials);
    CHECK(std::fabs(sum / trials - squared(mean - static_cast<double>(shown))) < 5 * error + 1e-6);
}

TEST_CASE("beyond white, the displayed error counts: radiance is cut off after the mean") {
    // A light of radiance L in a share c of the pixel, of which nothing was seen.
    const float light = GENERATE(0.5f, 4.f, 20.f, 500.f), coverage = GENERATE(0.01f, 0.05f, 0.3f);
    CAPTURE(light, coverage);
    const float mean = light * coverage;
    const double displayed = std::min(static_cast<double>(mean), 1.0);
    // Exactly: a sample hits it with a probability of c, and b is the true mean.
    const double hit = static_cast<double>(productOf(grey(light), grey(mean), grey(0)));
    const double miss = static_cast<double>(productOf(grey(0), grey(mean), grey(0)));
    const double c = static_cast<double>(coverage);
    CHECK(std::fabs(c * hit + (1 - c) * miss - displayed * displayed) < 1e-5);
}

TEST_CASE("a colour that is right has no product, and one that is not finite has a large one") {
    CHECK(productOf(grey(1), grey(0.25f), grey(0.25f)) == 0);
    CHECK(productOf(grey(7), grey(3), grey(2)) == 0);  // all white
    CHECK(productOf(grey(HUGE_VALF), grey(HUGE_VALF), grey(0)) == 1);
    CHECK(productOf(grey(NAN), grey(0.5f), grey(0)) == 1);
}

TEST_CASE("what the first samples miss is in the estimate, and in its band") {
    const auto [side, share] =
        GENERATE(table<float, double>({{0.3f, 0.05}, {0.2f, 0.2}, {0.5f, 0.02}, {0.1f, 0.5}}));
    const Dots dots{side, share};
    const Image exact = dots.exact();
    CAPTURE(side, share);
    constexpr int runs = 8;
    int near = 0, inBand = 0;
    double printed = 0, actual = 0;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const AdaptiveResult result = rendered(dots, 0.05f, 0, seed);
        const double rmse = compare(result.image, exact).rmse;
        near += result.estimatedRmse < 1.5 * rmse && result.estimatedRmse > rmse / 1.5;
        inBand += std::fabs(result.estimatedRmse - rmse) < 3 * result.estimatedRmseStandardError;
        printed += squared(result.estimatedRmse);
        actual += squared(rmse);
    }
    CAPTURE(near, inBand, std::sqrt(printed / runs), std::sqrt(actual / runs));
    CHECK(near >= runs - 2);
    CHECK(inBand >= runs - 1);
    CHECK(std::fabs(std::sqrt(printed / actual) - 1) < 0.25);
}

TEST_CASE("a target is meant, also where the first samples miss most", "[slow]") {
    const float target = GENERATE(0.01f, 0.005f);
    const Dots dots{0.2f, 0.05};
    const Image exact = dots.exact();
    int met = 0;
    constexpr int runs = 3;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const AdaptiveResult result = rendered(dots, 0, target, seed);
        CHECK(result.estimatedRmse <= static_cast<double>(target));
        met += compare(result.image, exact).rmse <= 1.2 * static_cast<double>(target);
    }
    CAPTURE(target, met);
    CHECK(met == runs);
}

TEST_CASE("nothing found is not nothing there: the band has the rule of three's width") {
    // One colour: whatever was missed has at most 3 / n of the flat pixels.
    const AdaptiveResult result = rendered([](float, float) { return grey(0); }, 0.01f, 0, 1);
    CHECK(result.estimatedRmse == 0);
    const double n = static_cast<double>(result.auditedPixels);
    CHECK(n > size * size / 8);
    CHECK(std::fabs(squared(result.estimatedRmseStandardError) * n - 0.25) < 1e-6);
}

TEST_CASE("the audit leaves a picture without details as it is, and costs an eighth") {
    const auto slope = [](float x, float y) { return grey(0.002f * x + 0.001f * y); };
    AdaptiveOptions options;
    options.tolerance = 0.02f;
    constexpr int large = 512;
    const AdaptiveResult result =
        renderAdaptive({0, 0, large, large}, large, large, slope, options);
    CHECK(static_cast<double>(result.samples) < 1.13 * large * large);
    CHECK(result.auditedPixels > large * large / 10);
}

TEST_CASE("errors that are estimated too large are measured", "[slow]") {
    // Upright edges, where samples in columns do far better than at edges of any direction.
    const auto stripes = [](float x, float) {
        const float place = x * 0.37f - std::floor(x * 0.37f);
        return grey(place < 0.3f ? 1.f : 0.f);
    };
    Image exact(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            double sum = 0;
            constexpr int fine = 20000;
            if (y > 0) {
                exact.at(x, y) = exact.at(x, 0);
                continue;
            }
            for (int i = 0; i < fine; ++i)
                sum += static_cast<double>(stripes(static_cast<float>(x + (i + 0.5) / fine), 0)[0]);
            exact.at(x, y) = grey(static_cast<float>(sum / fine));
        }
    for (const unsigned seed : {1u, 2u, 3u}) {
        const AdaptiveResult result = rendered(stripes, 0.01f, 0, seed);
        const double ratio = result.estimatedRmse / compare(result.image, exact).rmse;
        CAPTURE(seed, ratio);
        CHECK((ratio > 1 / 1.5 && ratio < 1.5));
    }
}

TEST_CASE("the audit is the same for any number of threads and any tiles") {
    const Dots dots{0.3f, 0.05};
    const auto with = [&](int threads, int tileSize) {
        AdaptiveOptions options;
        options.targetRmse = 0.01f;
        options.render.threads = threads;
        options.render.tileSize = tileSize;
        return renderAdaptive(whole, size, size, dots, options);
    };
    const AdaptiveResult one = with(1, 16);
    const auto threads = GENERATE(2, 5);
    const AdaptiveResult other = with(threads, 7);
    CHECK(other.samples == one.samples);
    CHECK(other.auditedPixels == one.auditedPixels);
    CHECK(other.estimatedRmse == one.estimatedRmse);
    CHECK(other.estimatedRmseStandardError == one.estimatedRmseStandardError);
    CHECK(compare(one.image, other.image).largest == 0);
}

TEST_CASE("a crop is the picture's, also where an audit has pixels sampled again") {
    const Dots dots{0.3f, 0.2};
    static const AdaptiveResult all = rendered(dots, 0.02f, 0, 1);
    const auto seed = GENERATE(range(0u, 4u));
    CAPTURE(seed);
    Random random(seed);
    const int x = random.whole(0, size - 1), y = random.whole(0, size - 1);
    const Window window{x, y, random.whole(x + 1, size), random.whole(y + 1, size)};
    AdaptiveOptions options;
    options.tolerance = 0.02f;
    const AdaptiveResult part = renderAdaptive(window, size, size, dots, options);
    int differing = 0;
    for (int j = window.y0; j < window.y1; ++j)
        for (int i = window.x0; i < window.x1; ++i)
            differing += !isSame(part.image.at(i - x, j - y), all.image.at(i, j));
    CHECK(differing == 0);
}
