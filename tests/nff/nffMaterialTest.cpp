#include "nff/field.h"

using namespace sw;
using namespace test;

namespace {

// Ks and T in the corner that is given, or anywhere.
struct Parts {
    float ks, t;
};
Parts randomParts(Random& random) {
    const float share = random.real(0, 1);
    const float sums[] = {random.real(0, 0.9), 1 - random.real(0, 0.001), 1, random.real(1, 3)};
    const float sum = sums[random.whole(0, 3)];
    return {share * sum, sum - share * sum};
}

std::string fill(const Color& color, float kd, const Parts& parts) {
    return "f " + text(color) + text(kd) + text(parts.ks) + "7 " + text(parts.t) + "1.5\n";
}

std::vector<std::string> colourWarnings(const std::string& statements) {
    return warningsOf(statements + "\nf 1 1 1 1 0 0 0 1 s 0 0 0 1");
}

const std::string beyond =
    " is beyond 1 (used as it is, though 1 is white, not 255; colours beyond 1 in this file: ";
const std::string negative = " is negative (used as it is; negative colours in this file: ";

}  // namespace

TEST_CASE("the diffuse part is Kd times the colour, whatever Ks and T are") {
    Random random(GENERATE(range(0u, 2000u)));
    const Color color(random.real(0, 1), random.real(0, 1), random.real(0, 1));
    const float kd = random.real(0.001, 1);
    const Parts parts = randomParts(random);
    const Material m = materialOf(fill(color, kd, parts) + "s 0 0 0 1");
    CAPTURE(color, kd, parts.ks, parts.t);
    const float diffuse = 1 - m.reflectivity - m.transparency;  // as traceRay() computes it
    CHECK(diffuse > 0);
    CHECK(distance(diffuse * m.color, toDouble(color) * static_cast<double>(kd)) <= 4 * u);
}

TEST_CASE("Ks and T are kept unless they leave no room for a diffuse part") {
    Random random(GENERATE(range(0u, 2000u)));
    const Parts parts = randomParts(random);
    const double sum = static_cast<double>(parts.ks) + static_cast<double>(parts.t);
    CAPTURE(parts.ks, parts.t, sum);
    const Material m = materialOf(fill({1, 1, 1}, 0.5f, parts) + "s 0 0 0 1");
    const double r = static_cast<double>(m.reflectivity), t = static_cast<double>(m.transparency);
    if (sum <= 1 - 0x1p-12) {
        CHECK((m.reflectivity == parts.ks && m.transparency == parts.t));
    } else {
        CHECK(std::fabs(r + t - (1 - 0x1p-12)) <= 2 * u);
        CHECK(std::fabs(r * sum - parts.ks * (r + t)) <= 4 * u);
    }
    // Nothing scatters: nothing makes way.
    for (const std::string none : {"f 1 1 1 0 ", "f 0 0 0 1 "}) {
        const Material pure =
            materialOf(none + text(parts.ks) + "7 " + text(parts.t) + "1.5 s 0 0 0 1");
        CHECK((pure.reflectivity == parts.ks && pure.transparency == parts.t));
        CHECK(distance(pure.color, Color(0, 0, 0)) == 0);
    }
}

TEST_CASE("Ks and T that add up to 1 give no warning, more gives one") {
    for (int tenth = 0; tenth <= 10; ++tenth) {
        const std::string parts = "1 1 1 0.1 " + text(tenth / 10.0) + "9 " + text(1 - tenth / 10.0);
        CHECK(warningsOf("f " + parts + "1.5 s 0 0 0 1").empty());
    }
    CHECK(warningsOf("f 1 1 1 0.1 0.333333 0 0.666667 1.5 s 0 0 0 1").empty());
    const std::string reduced =
        " (reduced to 1 where there is a diffuse part; Ks + T beyond 1 in this file: ";
    CHECK(warningsOf("f 1 1 1 0.9 0.9 0 0.9 1.5 s 0 0 0 1") ==
          std::vector{"a.nff:3:1: warning: Ks + T is 1.8, beyond 1" + reduced + "1)"});
    CHECK(warningsOf("f 1 1 1 0 2 0 0 1 s 0 0 0 1\nf 1 1 1 0 0 0 1.5 1\nb 1 1 1") ==
          std::vector{"a.nff:3:1: warning: Ks + T is 2, beyond 1" + reduced + "2)"});
}

TEST_CASE("colours beyond 0 to 1 give one warning for each kind, at the first") {
    CHECK(colourWarnings("b 51 76 128") ==
          std::vector{"a.nff:3:1: warning: colour (51, 76, 128)" + beyond + "1)"});
    CHECK(colourWarnings("f 1 1 1 1 0 0 0 1\nf 204 102 51 1 0 0 0 0 b 1 1 1.5") ==
          std::vector{"a.nff:4:1: warning: colour (204, 102, 51)" + beyond + "2)"});
    CHECK(colourWarnings("b 0 -0.5 1\nf -0.8 0 0 1 0 0 0 1\nl 0 0 9 0 0 -1") ==
          std::vector{"a.nff:3:1: warning: colour (0, -0.5, 1)" + negative + "3)"});
    CHECK(colourWarnings("b 2 -1 0") ==
          std::vector{"a.nff:3:1: warning: colour (2, -1, 0)" + beyond + "1)",
                      "a.nff:3:1: warning: colour (2, -1, 0)" + negative + "1)"});
    CHECK(colourWarnings("f 1 1 1 5 0 0 0 1\nf 1 1 1 1.1 0 0 0 1") ==
          std::vector<std::string>{"a.nff:3:1: warning: Kd is 5, beyond 1 (used as it is; Kd "
                                   "beyond 1 in this file: 2)"});
    CHECK(colourWarnings("b 0 0 1\nb 1 1 1\nf 1 0 -0 0 1 0 0 1\nf 0 0 0 1 0 0 1 1.5\nb -0 0 0")
              .empty());
}

TEST_CASE("lights may be brighter than 1, but not negative without a warning") {
    CHECK(colourWarnings("l 0 0 9 20 20 20").empty());
    CHECK(colourWarnings("l 0 0 9 20 -20 20") ==
          std::vector{"a.nff:3:1: warning: colour (20, -20, 20)" + negative + "1)"});
}

TEST_CASE("odd colours are used as they are") {
    CHECK(distance(parse("b 51 -76 128").scene.background(), Color(51, -76, 128)) == 0);
    CHECK(distance(materialOf("f 204 -1 0 2 0 0 0 1 s 0 0 0 1").color, Color(408, -2, 0)) == 0);
}
