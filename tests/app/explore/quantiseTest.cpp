// Numbers of --explore take few bytes, and nobody sees what that costs.
#include "app/explore/quantise.h"

#include <bit>
#include <cmath>
#include <limits>

#include "app/explore/packed.h"
#include "png.h"
#include "support.h"

using namespace test;

namespace {

float decoded24(std::uint32_t bits) {
    return std::bit_cast<float>(bits << 8);
}

float decoded16(std::uint32_t bits) {
    const int exponent = static_cast<int>(bits >> 10 & 31);
    const float sign = (bits & 0x8000) != 0 ? -1.f : 1.f, rest = static_cast<float>(bits & 1023);
    if (exponent == 31) return rest == 0 ? sign * INFINITY : NAN;
    return exponent == 0 ? sign * std::ldexp(rest, -24)
                         : sign * std::ldexp(1 + rest / 1024, exponent - 15);
}

Vec3 decodedDirection(std::uint32_t first, std::uint32_t second) {
    float u16 = static_cast<float>(first) / 32767 - 1, v = static_cast<float>(second) / 32767 - 1;
    const float w = 1 - std::fabs(u16) - std::fabs(v);
    if (w < 0) {
        const float folded = (1 - std::fabs(v)) * (u16 < 0 ? -1.f : 1.f);
        v = (1 - std::fabs(u16)) * (v < 0 ? -1.f : 1.f);
        u16 = folded;
    }
    return Vec3(u16, v, w).normalize();
}

constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace

TEST_CASE("three bytes keep a number to 2^-17 of it") {
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const float number = (random.coin() ? 1.f : -1.f) * random.magnitude(1e-37, 3e38);
        CHECK(float24(number) < 1u << 24);
        worst = std::max(worst, std::fabs(double(decoded24(float24(number))) / number - 1));
    }
    CHECK(worst <= 0x1p-16);
    for (const float exact : {0.f, 1.f, -2.5f, infinity, -infinity})
        CHECK(decoded24(float24(exact)) == exact);
    CHECK(std::isfinite(decoded24(float24(std::numeric_limits<float>::max()))));
    CHECK(std::isnan(decoded24(float24(-std::nanf("1")))));
}

TEST_CASE("two bytes keep a colour to 2^-11 of it") {
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const float number = (random.coin() ? 1.f : -1.f) * random.magnitude(7e-5, 6e4);
        CHECK(float16(number) < 1u << 16);
        worst = std::max(worst, std::fabs(double(decoded16(float16(number))) / number - 1));
    }
    CHECK(worst <= 0x1p-11);
    // Every half is its own nearest one.
    for (std::uint32_t half = 0; half < 0x10000; ++half)
        if (!std::isnan(decoded16(half)) && half != 0x8000) {
            if (float16(decoded16(half)) != half) CHECK(float16(decoded16(half)) == half);
        }
    CHECK(decoded16(float16(65520)) == infinity);
    CHECK(decoded16(float16(-infinity)) == -infinity);
    CHECK(std::isnan(decoded16(float16(NAN))));
}

TEST_CASE("four bytes keep a direction to a thousandth of a degree times four") {
    Random random(3);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 direction = random.direction();
        const OctDirection point = octahedral(direction);
        worst = std::max(worst, distance(decodedDirection(point.u, point.v), toDouble(direction)));
    }
    CHECK(worst < 7e-5);
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        const OctDirection point = octahedral(axis);
        CHECK(distance(decodedDirection(point.u, point.v), toDouble(axis)) < 1e-6);
    }
    CHECK(octahedral(Vec3(0, NAN, 1)).v == 65535);
}

TEST_CASE("base64 is RFC 4648's") {
    const auto [text, expected] =
        GENERATE(table<std::string, std::string>({{"", ""},
                                                  {"f", "Zg=="},
                                                  {"fo", "Zm8="},
                                                  {"foo", "Zm9v"},
                                                  {"foob", "Zm9vYg=="},
                                                  {"fooba", "Zm9vYmE="},
                                                  {"foobar", "Zm9vYmFy"},
                                                  {std::string("\0\xff\xfe", 3), "AP/+"}}));
    CHECK(base64(text) == expected);
}

#if SW_TEST_DECODES_PNG
TEST_CASE("columns come back from their bytes") {
    const int bytes = GENERATE(1, 2, 3, 4);
    const int count = GENERATE(1, 2, 1000, 70000);
    const bool smooth = GENERATE(false, true);
    Random random(static_cast<unsigned>(bytes * count));
    const std::uint32_t mask = 0xffffffffu >> (32 - 8 * bytes);
    std::vector<std::uint32_t> values;
    for (int i = 0; i < count; ++i)
        values.push_back((smooth ? static_cast<std::uint32_t>(i / 3) - 5u
                                 : static_cast<std::uint32_t>(random.uniform(0, 4294967295.0))) &
                         mask);
    const std::string packed = deflated(transposed(values, bytes));
    if (smooth && count == 70000) CHECK(packed.size() < values.size() / 10);
    int length = 0;
    char* const planes =
        stbi_zlib_decode_malloc(packed.data(), static_cast<int>(packed.size()), &length);
    REQUIRE(length == bytes * count);
    std::uint32_t before = 0;
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        std::uint32_t number = 0;
        for (int j = 0; j < bytes; ++j)
            number |= static_cast<std::uint32_t>(static_cast<unsigned char>(planes[j * count + i]))
                      << 8 * j;
        before = (before + (number >> 1 ^ (0u - (number & 1)))) & mask;
        wrong += before != values[static_cast<std::size_t>(i)];
    }
    std::free(planes);
    CHECK(wrong == 0);
}
#endif

TEST_CASE("nothing is packed as nothing") {
    CHECK(deflated(transposed({}, 4)).empty());
}
