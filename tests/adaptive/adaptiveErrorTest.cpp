#include <functional>
#include <numeric>

#include "support.h"
#include "swAdaptive.h"
#include "swMetrics.h"
#include "swNff.h"
#include "swSampling.h"
#include "testScenes.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

constexpr int size = 96;
const Window whole{0, 0, size, size};

const NffScene& lab() {
    static const NffScene file = [] {
        NffScene loaded = loadNff(SW_SCENES "/cornell.nff");
        loaded.camera.setup(size, size);
        return loaded;
    }();
    return file;
}

Color labRadiance(float x, float y) {
    return lab::traceRay(lab().camera.getRay(x, y), lab().scene, 3);
}

Image jittered(int n, std::uint64_t seed) {
    RenderOptions options;
    options.seed = seed;
    const auto pixel = [n](int x, int y) {
        return lab::samplePixel(static_cast<float>(x), static_cast<float>(y), n, 3, lab().camera,
                                lab().scene);
    };
    return render(whole, pixel, options).image;
}

double trueRmse(const Image& image) {
    static const Image reference = jittered(32, 4711);
    return compare(image, reference).rmse;
}

AdaptiveOptions limits(float tolerance, float targetRmse, std::uint64_t seed = 1) {
    AdaptiveOptions options;
    options.tolerance = tolerance;
    options.targetRmse = targetRmse;
    options.render.seed = seed;
    return options;
}

AdaptiveResult renderedLab(const AdaptiveOptions& options) {
    return renderAdaptive(whole, size, size, labRadiance, options);
}

// Thin triangles that stand apart, all of one width at the foot, seen from straight above; one unit
// is one pixel.
struct Hairs {
    static constexpr int side = 512, spacing = 32, perRow = side / spacing;
    float width, length;
    Scene scene;

    Hairs(float w, float l, unsigned seed) : width(w), length(l) {
        Random random(seed);
        for (int i = 0; i < perRow * perRow; ++i) {
            const double angle = random.uniform(0, 6.283);
            const Vec3 along(static_cast<float>(std::cos(angle)),
                             static_cast<float>(std::sin(angle)), 0);
            const Vec3 across(-along[1], along[0], 0);
            const Vec3 middle = Vec3((static_cast<float>(i % perRow) + 0.5f) * spacing,
                                     (static_cast<float>(i / perRow) + 0.5f) * spacing, 0) +
                                random.point(2);
            const Vec3 foot = middle - length / 2 * along;
            const Vec3 corners[] = {foot - width / 2 * across, foot + width / 2 * across,
                                    foot + length * along};
            scene.push(Triangle(corners, number(1)));
        }
    }
    double area() const { return 0.5 * width * length; }

    AdaptiveResult render(float tolerance) const {
        const auto radiance = [this](float x, float y) {
            const bool hit = hitBy(scene, Ray(Vec3(x, y, 1000), Vec3(0, 0, -1))) >= 0;
            return hit ? Color(1, 1, 1) : Color(0, 0, 0);
        };
        return renderAdaptive({0, 0, side, side}, side, side, radiance, limits(tolerance, 0));
    }

    // What the picture shows of each hair: a share of its area.
    std::vector<double> shownShares(const Image& image) const {
        std::vector<double> shares(perRow * perRow, 0.);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                shares[static_cast<std::size_t>(y / spacing * perRow + x / spacing)] +=
                    image.at(x, y)[0] / area();
        return shares;
    }
};

}  // namespace

TEST_CASE("the estimated RMSE is the true one within a factor of 1.5, mostly", "[adaptive][slow]") {
    constexpr int runs = 8;
    int near = 0, meant = 0;
    const auto judge = [&](const AdaptiveResult& result) {
        const double actual = trueRmse(result.image), ratio = result.estimatedRmse / actual;
        near += ratio > 1 / 1.5 && ratio < 1.5;
        CHECK(std::fabs(result.estimatedRmse - actual) < 3 * result.estimatedRmseStandardError);
        CHECK((ratio > 0.5 && ratio < 2));
    };
    SECTION("at a tolerance") {
        const float tolerance = GENERATE(0.1f, 0.05f, 0.02f, 0.01f, 0.005f);
        CAPTURE(tolerance);
        for (unsigned seed = 1; seed <= runs; ++seed)
            judge(renderedLab(limits(tolerance, 0, seed)));
        CHECK(near >= runs - 2);
    }
    SECTION("at a target") {
        const float target = GENERATE(0.02f, 0.01f, 0.005f, 0.0025f);
        CAPTURE(target);
        for (unsigned seed = 1; seed <= runs; ++seed) {
            const AdaptiveResult result = renderedLab(limits(0, target, seed));
            judge(result);
            CHECK(result.estimatedRmse <= target);
            CHECK(result.estimatedRmse > 0.5 * target);  // no waste
            meant += trueRmse(result.image) < 1.2 * static_cast<double>(target);
        }
        CHECK(near >= runs - 2);
        CHECK(meant >= runs - 1);
    }
}

TEST_CASE("the estimated errors say which pixels are wrong", "[adaptive][slow]") {
    const AdaptiveResult result = renderedLab(limits(0.02f, 0));
    Image reference = jittered(16, 99);
    double worst = 0, sum = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Vec3 d = result.image.at(x, y) - reference.at(x, y);
            const double error = std::sqrt((d * d) / 3);
            const double estimate = result.errors.at(x, y)[0];
            sum += error > 0.01 + 4 * estimate;
            worst = std::max(worst, error);
        }
    }
    CHECK(sum < size * size / 200);
    CHECK(worst < 0.3);
}

// In so small a picture; at 512 x 512 the share of edges, and so of samples, is far smaller.
TEST_CASE("jitter's RMSE takes half the samples of 3x3, a quarter of 8x8", "[adaptive][slow]") {
    const auto [n, gain] = GENERATE(table<int, int>({{3, 2}, {8, 4}}));
    const double error = trueRmse(jittered(n, 1));
    const AdaptiveResult result = renderedLab(limits(0, static_cast<float>(error)));
    CAPTURE(n, error, result.samples);
    CHECK(trueRmse(result.image) < 1.1 * error);
    // The audit has a cost of its own, which matters in so small a picture.
    const int samples = std::accumulate(result.sampleCounts.begin(), result.sampleCounts.end(), 0);
    CHECK(samples < size * size * n * n / gain);
}

TEST_CASE("whatever covers a whole pixel is seen", "[adaptive]") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    const float x0 = random.real(0, size - 2), y0 = random.real(0, size - 2);
    const auto square = [=](float x, float y) {
        return x >= x0 && x <= x0 + 2 && y >= y0 && y <= y0 + 2 ? Color(1, 1, 1) : Color(0, 0, 0);
    };
    const AdaptiveResult result = renderAdaptive(whole, size, size, square, limits(0.02f, 0, seed));
    double sum = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) sum += result.image.at(x, y)[0];
    CHECK(std::fabs(sum - 4) < 0.25);  // and with all of its area
}

TEST_CASE("a thin triangle is lost with a chance of at most exp(-area)", "[adaptive]") {
    const auto [width, length] =
        GENERATE(table<float, float>({{0.1f, 20.f}, {0.2f, 20.f}, {0.5f, 16.f}, {0.4f, 25.f}}));
    CAPTURE(width, length);
    int lost = 0, hairs = 0;
    double area = 0;
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
        const Hairs scene(width, length, seed);
        area = scene.area();
        for (const double share : scene.shownShares(scene.render(0.02f).image)) {
            lost += share == 0;
            ++hairs;
        }
    }
    const double expected = hairs * std::exp(-area);
    CHECK(lost <= expected + 3 * std::sqrt(expected) + 1);
}

TEST_CASE("a thin triangle that was seen is followed to its ends", "[adaptive]") {
    const auto [width, length] = GENERATE(table<float, float>({{0.2f, 25.f}, {0.5f, 25.f}}));
    CAPTURE(width, length);
    const Hairs scene(width, length, 7);
    const AdaptiveResult result = scene.render(0.01f);
    double sum = 0, seen = 0, poor = 0;
    for (const double share : scene.shownShares(result.image)) {
        if (share == 0) continue;
        ++seen;
        sum += share;
        poor += share < 0.75;
    }
    CAPTURE(seen, poor);
    CHECK(sum / seen > 0.93);
    CHECK(sum / seen < 1.05);
    CHECK(poor < 0.05 * seen);
    CHECK(result.samples < 12u * Hairs::side * Hairs::side);
}
