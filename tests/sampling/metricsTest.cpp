#include "swMetrics.h"

#include <limits>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

Image uniformImage(int width, int height, const Color& color) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.at(x, y) = color;
    return image;
}

Image randomImage(Random& random) {
    Image image(7, 5);
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x)
            for (float& channel : image.at(x, y).m) channel = random.real(-0.2, 1.3);
    return image;
}

Color heatOf(const Color& error) {
    return heatMap(uniformImage(1, 1, error)).at(0, 0);
}

}  // namespace

TEST_CASE("equal pictures do not differ") {
    Random random(GENERATE(range(0u, 10u)));
    const Image image = randomImage(random);
    const Metrics m = compare(image, image);
    CHECK((m.rmse == 0 && m.largest == 0 && m.visible == 0 && m.rmse8bit == 0));
    CHECK(m.psnr == std::numeric_limits<double>::infinity());
}

TEST_CASE("a constant difference is the RMSE and the largest difference") {
    Random random(GENERATE(range(0u, 50u)));
    const double a = random.uniform(0, 1), b = random.uniform(0, 1);
    CAPTURE(a, b);
    const auto gray = [](double v) {
        const auto f = static_cast<float>(v);
        return uniformImage(4, 3, Color(f, f, f));
    };
    const Metrics m = compare(gray(a), gray(b));
    const double d = std::fabs(a - b);
    CHECK(std::fabs(m.rmse - d) <= 4 * u);
    CHECK(std::fabs(m.largest - d) <= 4 * u);
    CHECK((m.x == 0 && m.y == 0));  // the first of all
    CHECK(std::fabs(m.psnr - 10 * std::log10(1 / (d * d))) <= 100 * u / d);
    CHECK(m.visible == (d > 2.0 / 255 ? 1 : 0));
    const double codeValues = 256 * std::fabs(std::pow(a, 1 / 2.2) - std::pow(b, 1 / 2.2));
    CHECK(std::fabs(m.rmse8bit - codeValues) <= 1e-4);
}

TEST_CASE("one channel of one pixel counts once among all channels") {
    const int x = GENERATE(0, 3, 9), y = GENERATE(0, 2, 4), channel = GENERATE(0, 1, 2);
    CAPTURE(x, y, channel);
    const Image a = uniformImage(10, 5, Color(0.25f, 0.25f, 0.25f));
    Image b = a;
    b.at(x, y)[channel] = 0.75f;
    const Metrics m = compare(a, b);
    CHECK(std::fabs(m.rmse - 0.5 / std::sqrt(150)) <= 1e-12);
    CHECK(std::fabs(m.psnr - 10 * std::log10(600)) <= 1e-9);
    CHECK(m.largest == 0.5);
    CHECK((m.x == x && m.y == y));
    CHECK(m.visible == 1.0 / 50);
}

TEST_CASE("differences count as visible from two steps of 255 on") {
    const auto [difference, visible] = GENERATE(
        table<float, int>({{1.9f / 255, 0}, {2.1f / 255, 1}, {-1.9f / 255, 0}, {-2.1f / 255, 1}}));
    const Image a = uniformImage(1, 1, Color(0.5f, 0.5f, 0.5f));
    const Image b = uniformImage(1, 1, Color(0.5f, 0.5f, 0.5f + difference));
    CHECK(compare(a, b).visible == visible);
}

TEST_CASE("differences that the picture cannot show do not count") {
    const Image white = uniformImage(2, 2, Color(1, 1, 1)), black = uniformImage(2, 2, Color());
    CHECK(compare(white, uniformImage(2, 2, Color(1, 5, infinity))).rmse == 0);
    CHECK(compare(black, uniformImage(2, 2, Color(-infinity, -1, NAN))).rmse == 0);
    CHECK(compare(white, uniformImage(2, 2, Color(1, 5, infinity))).rmse8bit == 0);
    const Metrics most = compare(uniformImage(2, 2, Color(9, 9, 9)), black);
    CHECK((most.rmse == 1 && most.psnr == 0 && most.largest == 1 && most.visible == 1));
    CHECK(most.rmse8bit == 256);
}

TEST_CASE("the order of the pictures does not matter") {
    Random random(GENERATE(range(0u, 10u)));
    const Image a = randomImage(random), b = randomImage(random);
    const Metrics ab = compare(a, b), ba = compare(b, a);
    CHECK((ab.rmse == ba.rmse && ab.largest == ba.largest && ab.visible == ba.visible));
    CHECK((ab.x == ba.x && ab.y == ba.y && ab.rmse8bit == ba.rmse8bit));
    CHECK(ab.rmse <= ab.largest);
}

TEST_CASE("code values are those of the bytes in the picture, whatever the gamma") {
    Random random(GENERATE(range(0u, 200u)));
    const float linear = random.real(-0.1, 1.1), gamma = random.real(0.5, 4);
    CAPTURE(linear, gamma);
    CHECK(std::fabs(codeValue(linear, gamma) - 0.5 - toByte(linear, gamma)) <= 0.5001);
}

TEST_CASE("every power of ten has its colour in the heat map") {
    const auto [error, color] = GENERATE(table<float, Color>({{0, {0, 0, 0}},
                                                              {1e-7f, {0, 0, 0}},
                                                              {1e-4f, {0, 0, 0}},
                                                              {1e-3f, {0, 0, 1}},
                                                              {1e-2f, {1, 0, 0}},
                                                              {1e-1f, {1, 1, 0}},
                                                              {1, {1, 1, 1}},
                                                              {infinity, {1, 1, 1}},
                                                              {NAN, {0.2f, 0.2f, 0.2f}}}));
    CAPTURE(error);
    CHECK(distance(heatOf(Color(error, error, error)), color) < 1e-5);
    // The root mean square over the channels.
    const float one = error * std::sqrt(3.0f);
    CHECK(distance(heatOf(Color(0, one, 0)), color) < 1e-5);
}

TEST_CASE("colours between two powers of ten are mixed") {
    const float between = std::pow(10.0f, -2.75f);
    CHECK(distance(heatOf(Color(between, between, between)), Color(0.25f, 0, 0.75f)) < 1e-5);
}

TEST_CASE("the absolute difference is what the metrics summarize") {
    Random random(GENERATE(range(0u, 10u)));
    const Image a = randomImage(random), b = randomImage(random);
    const Image difference = absoluteDifference(a, b);
    const Metrics direct = compare(a, b), ofDifference = compare(difference, Image(7, 5));
    CHECK(std::fabs(direct.rmse - ofDifference.rmse) < 1e-7);
    CHECK(std::fabs(direct.largest - ofDifference.largest) < 1e-7);
}
