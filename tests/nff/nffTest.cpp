#include "nff/nff.h"

#include <clocale>
#include <locale>

using namespace sw;
using namespace test;

namespace {

// The radius of a sphere as the number is spelt.
double radiusOf(const std::string& number) {
    Intersection hit;
    const NffScene file = parse(grey + "s 0 0 0 " + number);
    REQUIRE(file.scene.intersect(Ray(Vec3(0, 0, 1e4f), Vec3(0, 0, -1)), hit));
    return 1e4 - static_cast<double>(hit.hitT);
}

std::string replaced(std::string where, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = where.find(what, at)) != std::string::npos; at += by.size())
        where.replace(at, what.size(), by);
    return where;
}

// Sets the global locale of C and C++ to one that writes 0,5, and resets both.
struct CommaLocale {
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
    };
    CommaLocale() : before(std::locale::global(std::locale(std::locale::classic(), new Comma))) {
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "German"})
            if (std::setlocale(LC_ALL, name)) return;
    }
    ~CommaLocale() {
        std::locale::global(before);
        std::setlocale(LC_ALL, "C");
    }
    std::locale before;
};

}  // namespace

TEST_CASE("the view sets the camera and the size of the picture") {
    const NffScene file =
        parseNff("v from 1 2 3 at 1 2 -7 up 0 2 0 angle 60 hither 0 resolution 40 20", "test.nff");
    CHECK((file.width == 40 && file.height == 20));
    const Ray center = file.camera.getRay(20, 10);
    CHECK(distance(center.orig, Vec3(1, 2, 3)) == 0);
    CHECK(distance(center.dir, Vec3(0, 0, -1)) <= u);
    // Half of the vertical field of view lies above the centre.
    CHECK(distance(file.camera.getRay(20, 0).dir, dvec3(0, 0.5, -std::sqrt(0.75))) <= 2 * u);
}

TEST_CASE("the view may stand anywhere in the file") {
    const std::string statements = "l 1 2 3\n" + grey + "s 0 0 0 1\n";
    for (const std::string& file :
         {view + statements, statements + view, "l 1 2 3\n" + view + grey + "s 0 0 0 1"}) {
        const NffScene parsed = parseNff(file, "test.nff");
        Intersection hit;
        CHECK(parsed.width == 8);
        CHECK(parsed.scene.lights().size() == 1);
        CHECK(parsed.scene.intersect(parsed.camera.getRay(4, 2), hit));
    }
}

TEST_CASE("the background is black unless the file sets it") {
    CHECK(distance(parse("").scene.background(), Color(0, 0, 0)) == 0);
    CHECK(distance(parse("b 0.25 0.5 1").scene.background(), Color(0.25f, 0.5f, 1)) == 0);
    CHECK(distance(parse("b 1 1 1 b 0 0.5 0").scene.background(), Color(0, 0.5f, 0)) == 0);
}

TEST_CASE("lights without a colour share the light and others keep theirs") {
    Random random(GENERATE(range(0u, 30u)));
    const int count = random.whole(1, 20);
    std::string statements;
    std::vector<Light> expected;
    const float share = static_cast<float>(1 / std::sqrt(count));
    for (int i = 0; i < count; ++i) {
        const Vec3 place = random.point(10), color = random.point(1);
        const bool own = random.coin();
        statements += "l " + text(place) + (own ? text(color) : "") + "\n";
        expected.emplace_back(place, own ? color : Color(share, share, share));
    }
    CAPTURE(statements);
    const std::vector<Light> lights = parse(statements).scene.lights();
    REQUIRE(lights.size() == expected.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        CHECK(distance(lights[i].position, expected[i].position) == 0);
        CHECK(distance(lights[i].color, expected[i].color) <= 2 * u);
    }
}

TEST_CASE("the index of refraction counts only where there is transparency") {
    CHECK(materialOf("f 1 1 1 0 0.2 0 0.8 1.3 s 0 0 0 1").refractiveIndex == 1.3f);
    CHECK(materialOf("f 1 1 1 0 0.2 0 0.001 0.5 s 0 0 0 1").refractiveIndex == 0.5f);
    for (const std::string index : {"0", "-1", "1.7"})
        CHECK(materialOf("f 1 1 1 1 0 0 0 " + index + " s 0 0 0 1").refractiveIndex == 1);
}

TEST_CASE("objects take the last material before them") {
    const NffScene file = parse(
        "f 1 0 0 1 0 0 0 1  s -4 0 0 1  f 0 1 0 1 0 0 0 1  s 0 0 0 1"
        " p 3  3 -1 0  5 -1 0  4 2 0  f 0 0 1 1 0 0 0 1");
    const auto colorAt = [&](float x) {
        Intersection hit;
        REQUIRE(file.scene.intersect(Ray(Vec3(x, 0, 5), Vec3(0, 0, -1)), hit));
        return hit.material.color;
    };
    CHECK(distance(colorAt(-4), Color(1, 0, 0)) == 0);
    CHECK(distance(colorAt(0), Color(0, 1, 0)) == 0);
    CHECK(distance(colorAt(4), Color(0, 1, 0)) == 0);
}

TEST_CASE("a convex polygon is hit inside its edges alone and from both sides") {
    Random random(GENERATE(range(0u, 100u)));
    const int corners = random.whole(3, 12);
    std::vector<double> angles;
    for (int i = 0; i < corners; ++i) angles.push_back((i + random.uniform(0, 0.8)) / corners);
    std::string statement = grey + "p " + std::to_string(corners) + "\n";
    std::vector<dvec3> polygon;
    for (const double turn : angles) {
        const double angle = turn * 2 * std::acos(-1.0);
        const Vec3 corner = sw::num::toFloat(dvec3(2 * std::cos(angle), std::sin(angle), 0));
        statement += text(corner) + "\n";
        polygon.push_back(toDouble(corner));
    }
    const Scene scene = parse(statement).scene;
    int wrong = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p(random.real(-2.2, 2.2), random.real(-1.2, 1.2), 0);
        bool inside = true;
        for (int k = 0; k < corners; ++k) {
            const dvec3 a = polygon[static_cast<std::size_t>(k)];
            const dvec3 b = polygon[static_cast<std::size_t>((k + 1) % corners)];
            inside = inside && glm::cross(b - a, toDouble(p) - a).z > 0;
        }
        Intersection hit;
        const float side = random.coin() ? 1.0f : -1.0f;  // counter-clockwise seen from +z
        const bool found = scene.intersect(Ray(p + Vec3(0, 0, side), Vec3(0, 0, -side)), hit);
        if (found != inside || (found && hit.frontFacing != (side > 0))) ++wrong;
    }
    CAPTURE(statement);
    CHECK(wrong == 0);
}

TEST_CASE("numbers may be spelt in every usual way") {
    const auto [spelling, value] = GENERATE(table<std::string, double>({{"2", 2},
                                                                        {"+2", 2},
                                                                        {"2.", 2},
                                                                        {"2.0", 2},
                                                                        {".5", 0.5},
                                                                        {"+.5", 0.5},
                                                                        {"002", 2},
                                                                        {"1e3", 1000},
                                                                        {"1E+3", 1000},
                                                                        {"+1.25e+1", 12.5},
                                                                        {"2500e-1", 250},
                                                                        {"0.0003e4", 3}}));
    CAPTURE(spelling);
    CHECK(radiusOf(spelling) == value);
    CHECK(parse("b -0 -.5 " + spelling).scene.background()[2] == static_cast<float>(value));
    CHECK(parse("b -0 -.5 -" + spelling.substr(spelling[0] == '+')).scene.background()[1] == -0.5f);
}

TEST_CASE("numbers do not depend on the locale") {
    const CommaLocale comma;
    CHECK(radiusOf("1.5") == 1.5);
    CHECK(radiusOf("1234.5") == 1234.5);
    CHECK_THROWS_AS(radiusOf("1,5"), NffError);
}

TEST_CASE("any white space separates and comments end with the line") {
    const std::string file = view + "l 1 2 3 0.5 0.25 1\n" + grey + "s 0 0 0 1\n";
    const auto variant = GENERATE_COPY(
        replaced(file, "\n", "\r\n"), replaced(file, " ", "\t"), replaced(file, "\n", " "),
        replaced(file, " ", "\n\n"), replaced(file, " ", " \v\f\r "),
        replaced(file, " ", " # a comment: v s 1 2\n"), replaced(file, "v\n", "v#no space\n"),
        replaced(file, "\n", " #CRLF\r\n"), replaced(file, "\n", " # a comment: s 9 9\r"),
        std::string("\xef\xbb\xbf").append(file),
        std::string("#").append(replaced(file, "\n", " ")).append("\n").append(file),
        file + "# no end of line", file.substr(0, file.size() - 1), "\n\n\t " + file + " \t\n");
    CAPTURE(variant);
    const NffScene parsed = parseNff(variant, "test.nff");
    REQUIRE(parsed.scene.lights().size() == 1);
    CHECK(distance(parsed.scene.lights()[0].color, Color(0.5f, 0.25f, 1)) == 0);
    Intersection hit;
    REQUIRE(parsed.scene.intersect(parsed.camera.getRay(4, 2), hit));
    CHECK(hit.hitT == 4);
    CHECK(distance(hit.material.color, Color(0.5f, 0.5f, 0.5f)) == 0);
}
