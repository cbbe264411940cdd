#include <sstream>

#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

// Looks into a pixel of the lab's scene.
std::string look(const std::string& arguments) {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.code == 0);
    CHECK(run.err.empty());
    CHECK(folder.count() == 0);  // no picture
    return run.out;
}

// The same for a scene of one's own.
std::string lookAt(const std::string& nff, const std::string& arguments = "") {
    const TemporaryFolder folder;
    makeFile(folder / "a.nff",
             "v from 0 0 9 at 0 0 0 up 0 1 0 angle 45 hither 1\n"
             "resolution 3 3\n" +
                 nff);
    const Run run = swtracer(folder, "a.nff --pixel 1,1 " + arguments);
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK(folder.count() == 1);
    return run.out;
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

void checkRefused(const std::string& arguments, const std::string& message) {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, arguments);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.code == 2);
    CHECK(run.out.empty());
    CHECK(lines(run.err) == 1);
    CHECK(has(run.err, message));
    CHECK(folder.count() == 0);
}

}  // namespace

TEST_CASE("a pixel of glass shows reflected and refracted rays and where their light is from") {
    const std::string tree = look("--pixel 129,250 --depth 2");
    CAPTURE(tree);
    CHECK(startsWith(tree, "pixel 129,250 of 512x512, through its centre: shown as "));
    CHECK(count(tree, "primary ray, depth 2: colour (") == 1);
    CHECK(count(tree, "hits sphere (line 56, centre (-9, 10, 0), radius 3), front, t = ") == 1);
    CHECK(count(tree, "reflected ray, weight 0.2, depth 1: colour (") == 1);
    CHECK(count(tree, "refracted ray, weight 0.8, depth 1: colour (") == 1);
    CHECK(count(tree, ", weight 0.2, depth 0: ") == 1);
    CHECK(count(tree, ", weight 0.8, depth 0: ") == 1);
    CHECK(count(tree, "shadow ray to light 1 at (0, 30, -5): lit, adds (") == 2);
    CHECK(count(tree, "hits triangle (line 32, (-20, 0, 50) (-20, 0, -50) ") == 1);
    CHECK(count(tree, "!!") == 0);
    CHECK(count(tree, "\n+- ") == 2);
}

TEST_CASE("size and depth choose the ray and its tree") {
    const std::string small = look("--pixel 1,2 --size 4x4 --depth 0");
    CHECK(startsWith(small, "pixel 1,2 of 4x4, "));
    CHECK(count(small, "flected ray") + count(small, "fracted ray") == 0);
    CHECK((look("--pixel 1,2 --size 4x4 --depth 0 --seed 9") == small));
    CHECK((look("--size=4x4 --pixel=2,1 --depth=0") != small));
}

#if SW_TEST_DECODES_PNG
TEST_CASE("the colour is the one of the picture") {
    const auto [x, y] = GENERATE(table<int, int>({{0, 0}, {15, 8}, {5, 6}, {8, 3}, {12, 5}}));
    const auto pixels = decodePng(picture("--size 16x9 --samples 1 --quiet"));
    const std::string at = std::to_string(x) + "," + std::to_string(y);
    std::string expected = "shown as";
    for (int i = 0; i < 3; ++i)
        expected.append(" ").append(
            std::to_string(pixels[static_cast<std::size_t>(3 * (16 * y + x) + i)]));
    CAPTURE(at, expected);
    CHECK(has(look("--size 16x9 --pixel " + at), expected + "\n"));
}
#endif

TEST_CASE("every shape is named by what it is and where it stands in the file") {
    const std::string f = "l 0 0 9\n# a comment\nf 1 1 1 1 0 0 0 1\n";  // lines 3 to 5
    CHECK(has(lookAt(f + "s 0 0 0 1"), "hits sphere (line 6, centre (0, 0, 0), radius 1), front"));
    CHECK(has(lookAt(f + "\n s 9 9 0 1 s 0 0 9.5 2"),
              "hits sphere (line 7, centre (0, 0, 9.5), "
              "radius 2), back"));
    CHECK(has(lookAt(f + "c 0 -1 0 1\n0 1 0 0.5"),
              "hits cone (line 6, base (0, -1, 0), radius 1, apex (0, 1, 0), radius 0.5), front"));
    CHECK(has(lookAt(f + "p 3 -1 -1 0 1 -1 0\n0 1 0"),
              "hits triangle (line 6, (-1, -1, 0) (1, -1, 0) (0, 1, 0)), front"));
    CHECK(has(lookAt(f + "pp 3 -1 -1 0 0 0 1 1 -1 0 0 0 1 0 1 0 0 0 1"),
              "hits patch (line 6, (-1, -1, 0) (1, -1, 0) (0, 1, 0)), front"));
    CHECK(has(lookAt(f + "p 4 -1 -1 0  1 -1 0  1 1 0  -1 1.5 0"), "hits triangle (line 6, "));
    CHECK(has(lookAt(f), "hits nothing"));
}

TEST_CASE("shapes in a tree are named like those in a linear scan") {
    std::ostringstream spheres;
    for (int i = 0; i < 100; ++i) spheres << "s " << i - 50 << " 0 -3 0.4\n";
    CHECK(has(lookAt("f 1 1 1 1 0 0 0 1\n" + spheres.str()),
              "hits sphere (line 54, centre (0, 0, -3), radius 0.4), front, t = 11.6 at "
              "(0, 0, -2.6), normal (0, 0, 1)"));
}

TEST_CASE("if two shapes coincide the one whose colour is seen is named") {
    const std::string tree = lookAt(
        "l 0 0 9\nf 1 0 0 1 0 0 0 1\npp 3 -1 -1 0 0 0 1 1 -1 0 0 0 1 0 1 0 0 0 1\n"
        "f 0 1 0 1 0 0 0 1\np 3 -1 -1 0 1 -1 0 0 1 0\n");
    CAPTURE(tree);
    CHECK(has(tree, "colour (0, 1, 0)") == has(tree, "hits triangle (line 7, "));
    CHECK(has(tree, "colour (1, 0, 0)") == has(tree, "hits patch (line 5, "));
}

TEST_CASE("each of two lights in one direction has its own shadow ray") {
    const std::string tree = lookAt("l 0 0 9\nl 0 0 20\nl 0 0 5\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n");
    CAPTURE(tree);
    CHECK((count(tree, "light 1 at") == 1 && count(tree, "light 2 at") == 1));
    CHECK(count(tree, "light 3 at") == 1);
    CHECK_FALSE(has(tree, "without a shadow ray"));
}

TEST_CASE("a blocked light names what stands in its way") {
    const std::string tree =
        lookAt("l 0 0 20\nl 3 0 20\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\ns 0 0 15 2\n");
    CAPTURE(tree);
    CHECK(has(tree, "shadow ray to light 1 at (0, 0, 20): blocked, adds (0, 0, 0)\n"));
    CHECK(has(tree, "hits sphere (line 7, centre (0, 0, 15), radius 2), front"));
}

TEST_CASE("2 for a pixel outside of the picture") {
    for (const std::string at : {"4,0", "0,3", "99999,0", "4,3"})
        checkRefused("--size 4x3 --pixel " + at,
                     "--pixel: expected a pixel within 4x3, found " + at);
    for (const std::string at : {"-1,0", "0,-1", "1", "1,2,3", "1x2", "", "a,b", "1.5,2", "1, 2"})
        checkRefused("\"--pixel=" + at + "\"", "--pixel");
}

TEST_CASE("2 for options of a picture beside --pixel") {
    for (const std::string other :
         {"-o a.png", "--samples 2", "--sampler grid", "--adaptive 0.1", "--target-rmse 0.1",
          "--time-limit 1", "--corners", "--threads 1", "--crop 0,0,1,1", "--quiet",
          "--stats s.json", "--error-image e.png"}) {
        const std::string name =
            other == "-o a.png" ? "--output" : other.substr(0, other.find(' '));
        checkRefused("--pixel 1,1 " + other, "--pixel: expected no " + name + " beside it");
    }
}
