#include "swImage.h"

#include <limits>

#include "files.h"
#include "png.h"
#include "support.h"
#include "swFile.h"

using namespace sw;
using namespace test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

double encoded(double linear, double gamma) {
    return 256 * std::min(std::pow(linear, 1 / gamma), 0.999);
}

// Pixels of all kinds, some of them beyond what a picture shows.
Image randomImage(int width, int height, Random& random) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (float& channel : image.at(x, y).m) channel = random.real(-0.2, 1.3);
    return image;
}

}  // namespace

TEST_CASE("a new picture is black") {
    const Image image(3, 2);
    CHECK((image.width() == 3 && image.height() == 2));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) CHECK(distance(image.at(x, y), Color(0, 0, 0)) == 0);
}

TEST_CASE("every pixel has a place of its own") {
    Image image(5, 7);
    const auto mark = [](int x, int y) { return static_cast<float>(x + 100 * y); };
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 5; ++x) image.at(x, y) = Color(mark(x, y), 0, -mark(x, y));
    const Image copy = image;
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 5; ++x)
            CHECK(distance(copy.at(x, y), Color(mark(x, y), 0, -mark(x, y))) == 0);
}

TEST_CASE("a byte is the gamma-encoded radiance in 256 steps") {
    Random random(GENERATE(range(0u, 1000u)));
    const float linear = random.real(0, 1.2), gamma = random.real(0.5, 4);
    CAPTURE(linear, gamma);
    const double exact = encoded(linear, gamma);
    // Rounding in float may tip a value that lies on the border of two steps.
    CHECK(toByte(linear, gamma) >= std::floor(exact - 1e-3));
    CHECK(toByte(linear, gamma) <= std::floor(exact + 1e-3));
}

TEST_CASE("the usual gamma is 2.2") {
    for (float linear = 0; linear < 1.1f; linear += 0.01f)
        CHECK(toByte(linear) == toByte(linear, 2.2f));
    CHECK(toByte(0.5f) == 186);  // 256 * 0.5^(1/2.2) = 186.8
}

TEST_CASE("radiance out of range ends at black or white") {
    for (const float none : {-infinity, -1.0f, -1e-30f, -0.0f, 0.0f, NAN}) CHECK(toByte(none) == 0);
    for (const float bright : {1.0f, 1.001f, 1e30f, infinity}) CHECK(toByte(bright) == 255);
}

TEST_CASE("more light never makes a darker byte and all 256 bytes occur") {
    int steps = 0, violations = 0;
    std::uint8_t last = 0;
    for (int i = 0; i <= 1 << 17; ++i) {
        const std::uint8_t byte = toByte(static_cast<float>(i) * 0x1p-17f);
        if (byte < last) ++violations;
        if (byte != last) ++steps;
        last = byte;
    }
    CHECK(violations == 0);
    CHECK(steps == 255);
}

TEST_CASE("a PNG is well-formed and has the size of its picture") {
    const auto width = GENERATE(1, 2, 17, 300);
    const auto height = GENERATE(1, 3, 64);
    CAPTURE(width, height);
    Random random(static_cast<unsigned>(1000 * width + height));
    const TemporaryFolder folder;
    writePng(randomImage(width, height, random), folder / "a.png");
    const std::string png = contentOf(folder / "a.png");
    const PngStructure structure(png);
    CHECK(structure.width == static_cast<unsigned>(width));
    CHECK(structure.height == static_cast<unsigned>(height));
}

#if SW_TEST_DECODES_PNG
TEST_CASE("a PNG read back holds the byte of every channel") {
    Random random(GENERATE(range(0u, 20u)));
    const Image image = randomImage(random.whole(1, 40), random.whole(1, 40), random);
    const float gamma = random.real(1, 3);
    CAPTURE(image.width(), image.height(), gamma);
    std::vector<std::uint8_t> expected;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const float channel : image.at(x, y).m) expected.push_back(toByte(channel, gamma));
    const TemporaryFolder folder;
    writePng(image, folder / "a.png", gamma);
    CHECK((decodePng(contentOf(folder / "a.png")) == expected));
}
#endif

TEST_CASE("a PNG that cannot be written is an error and leaves nothing behind") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(writePng(Image(2, 2), folder / "missing/a.png"), FileError);
    CHECK_THROWS_AS(writePng(Image(2, 2), folder.path), FileError);
    CHECK(folder.count() == 0);
}
