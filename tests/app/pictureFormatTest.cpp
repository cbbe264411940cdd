// Pictures of linear values: .pfm and .hdr.
#include "app/pictureFormat.h"

#include <bit>
#include <cstring>
#include <limits>

#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

const std::string pixels = "--size 24x16 --samples 2 --quiet -o ";

sw::Image randomImage(int width, int height, Random& random) {
    sw::Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (float& channel : image.at(x, y).m)
                channel = random.whole(0, 9) == 0 ? 0 : random.magnitude(1e-6, 1e6);
    return image;
}

// Reads what encode() makes of an image, by the definition of the format.
sw::Image decodePfm(const std::string& bytes, int width, int height) {
    const std::string header =
        "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    REQUIRE(bytes.substr(0, header.size()) == header);
    REQUIRE(bytes.size() == header.size() + 12 * static_cast<std::size_t>(width * height));
    sw::Image image(width, height);
    const char* at = bytes.data() + header.size();
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (float& channel : image.at(x, y).m) {
                std::uint32_t bits = 0;
                for (int i = 0; i < 4; ++i)
                    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(*at++))
                            << (8 * i);
                channel = std::bit_cast<float>(bits);
            }
    return image;
}

// Reads a Radiance picture, plain or run-length encoded, as its reference manual says.
sw::Image decodeHdr(const std::string& bytes, int width, int height) {
    REQUIRE(bytes.substr(0, 11) == "#?RADIANCE\n");
    REQUIRE(has(bytes, "\nFORMAT=32-bit_rle_rgbe\n"));
    const std::size_t end =
        bytes.find("-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n");
    REQUIRE(end != std::string::npos);
    std::size_t at = bytes.find('\n', end) + 1;
    const auto next = [&] { return static_cast<unsigned char>(bytes.at(at++)); };
    sw::Image image(width, height);
    for (int y = 0; y < height; ++y) {
        std::vector<unsigned char> row(static_cast<std::size_t>(4 * width));
        const bool packed = width >= 8 && width < 32768;
        if (packed) REQUIRE((next() == 2 && next() == 2 && next() * 256 + next() == width));
        for (std::size_t channel = 0; channel < 4 && packed; ++channel)
            for (std::size_t x = 0; x < static_cast<std::size_t>(width);) {
                const int count = next();
                const unsigned char same = count > 128 ? next() : 0;
                for (int i = 0; i < (count > 128 ? count - 128 : count); ++i)
                    row.at(4 * x++ + channel) = count > 128 ? same : next();
            }
        if (!packed) std::generate(row.begin(), row.end(), next);
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t pixel = static_cast<std::size_t>(4 * x);
                image.at(x, y).m[c] = row[pixel + 3] == 0
                                          ? 0
                                          : std::ldexp(row[pixel + c] + 0.5f, row[pixel + 3] - 136);
            }
    }
    CHECK(at == bytes.size());
    return image;
}

}  // namespace

TEST_CASE("a PFM holds every float bit for bit") {
    Random random(GENERATE(range(0u, 10u)));
    const int width = random.whole(1, 40), height = random.whole(1, 30);
    sw::Image image = randomImage(width, height, random);
    image.at(0, 0) = sw::Color(-1, std::numeric_limits<float>::infinity(), -0.0f);
    const sw::Image read = decodePfm(encode(image, PictureFormat::pfm, 2.2f), width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            CHECK(std::memcmp(read.at(x, y).m, image.at(x, y).m, sizeof image.at(x, y).m) == 0);
}

TEST_CASE("an HDR holds each pixel up to a part in 128 of its largest channel") {
    Random random(GENERATE(range(0u, 10u)));
    const int width = random.whole(1, 400), height = random.whole(1, 8);
    const sw::Image image = randomImage(width, height, random);
    const sw::Image read = decodeHdr(encode(image, PictureFormat::hdr, 2.2f), width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const sw::Color &a = image.at(x, y), &b = read.at(x, y);
            const float largest = std::max({a[0], a[1], a[2]});
            for (int c = 0; c < 3; ++c) CHECK(std::fabs(a[c] - b[c]) <= largest / 128);
        }
}

TEST_CASE("an HDR shows what it cannot hold as black or very bright") {
    sw::Image image(9, 1);
    const float infinity = std::numeric_limits<float>::infinity();
    image.at(0, 0) = sw::Color(NAN, -1, -infinity);
    image.at(1, 0) = sw::Color(infinity, 0, 0);
    image.at(2, 0) = sw::Color(std::numeric_limits<float>::max(), 0, 0);
    const sw::Image read = decodeHdr(encode(image, PictureFormat::hdr, 2.2f), 9, 1);
    CHECK(read.at(0, 0).isZero());
    CHECK(read.at(1, 0)[0] > 1e37f);
    CHECK(read.at(2, 0)[0] > 1e37f);
}

TEST_CASE("a PFM of the program holds the values behind the PNG") {
    const TemporaryFolder folder;
    for (const std::string name : {"a.png", "a.pfm", "a.hdr"})
        REQUIRE(swtracer(folder, pixels + name).code == 0);
    const sw::Image linear = decodePfm(contentOf(folder / "a.pfm"), 24, 16);
    CHECK((encode(linear, PictureFormat::png, 2.2f) == contentOf(folder / "a.png")));
    CHECK((encode(linear, PictureFormat::hdr, 2.2f) == contentOf(folder / "a.hdr")));
}

TEST_CASE("no picture file is smaller than its least size, and a PFM hardly larger") {
    for (const auto format : {PictureFormat::png, PictureFormat::pfm, PictureFormat::hdr})
        for (const int width : {1, 7, 8, 500})
            for (const int height : {1, 300}) {
                const std::size_t size = encode(sw::Image(width, height), format, 2.2f).size();
                CAPTURE(width, height, size);
                CHECK(leastSize(format, width, height) <= size);
                if (format == PictureFormat::pfm)
                    CHECK(leastSize(format, width, height) + 30 > size);
            }
}

TEST_CASE("each format is known by its ending in either case and by its first bytes") {
    const sw::Image image(3, 2);
    for (const auto& [name, format] :
         {std::pair("a.png", PictureFormat::png), std::pair("b.PFM", PictureFormat::pfm),
          std::pair("c.d/.e.Hdr", PictureFormat::hdr)}) {
        CHECK(formatOf(name) == format);
        CHECK(isPicture(encode(image, format, 2.2f).substr(0, 16)));
    }
    for (const char* name : {"", "png", ".png", "a.png.bak", "a.png/", "a.jpg", "a."})
        CHECK_FALSE(formatOf(name));
    CHECK_FALSE(isPicture(""));
    CHECK_FALSE(isPicture("P3\n"));
}
