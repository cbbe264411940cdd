#include "nff/field.h"

using namespace sw;
using namespace test;

namespace {

const std::string skipped =
    " is a statement of 1990 (skipped; statements number and g in this file: ";
const std::string textures =
    "warning: the name behind the material's numbers is not used (textures are not part of the "
    "format; such names in this file: ";

std::vector<std::string> ballWarnings(const BallFile& file) {
    const NffScene scene = parseNff(file.text(), "a.nff");
    CHECK(isBallScene(scene));
    return scene.warnings;
}

}  // namespace

TEST_CASE("number and g are skipped with one warning for both") {
    BallFile file;
    file.resolution += "number 2\ng -1 1 -1 1 -1 1\n";
    CHECK(ballWarnings(file) == std::vector{"a.nff:8:1: warning: number" + skipped + "2)"});
    file = {};
    file.floor += " g -1 1 -1 1 -1 1";
    CHECK(ballWarnings(file) == std::vector{"a.nff:18:2: warning: g" + skipped + "1)"});
    checkErrors(
        {{"number\ns 0 0 0 1", "3:7: expected 1 number after 'number', found 0"},
         {"g 1 2 3 4 5\nb 0 0 0", "3:12: expected 6 numbers after 'g', found 5: 1 is missing"},
         {"b 0 0\ng 1 2 3 4 5 6",
          "3:6: expected 3 numbers after 'b', found 2: 1 is missing (r g b)"}});
}

TEST_CASE("a texture's name behind a material is skipped with one warning") {
    const std::string name = GENERATE(as<std::string>(), "brick.png", "textures/brick", "s.gif",
                                      "brick.png # a comment", "brick.png   ");
    BallFile file;
    file.material = replaced(file.material, "\n", " " + name + "\n");
    CHECK(ballWarnings(file) == std::vector{"a.nff:10:1: " + textures + "1)"});
    file.floor = replaced(file.floor, "0\np 4", "0 " + name + "\np 4");
    CHECK(ballWarnings(file) == std::vector{"a.nff:10:1: " + textures + "2)"});
}

TEST_CASE("only the last word of a material's line is a texture") {
    const std::string fill = "f 1 1 1 1 0 0 0 1";
    CHECK(warningsOf("s 0 0 0 1\n" + fill + " s 0 0 0 1").empty());
    CHECK(warningsOf("s 0 0 0 1\n" + fill + " s\n0 0 0 1").empty());
    CHECK(warningsOf("s 0 0 0 1 " + fill).empty());
    CHECK(parseNff(fill + " " + good + "s 0 0 0 1", "a.nff").warnings.empty());
    const std::string expected = "expected a statement (v, b, l, f, s, c, p or pp), found ";
    checkErrors({{fill + "\nbrick.png\n", "4:1: " + expected + "'brick.png'"},
                 {fill + " brick.png wall.png\n", "3:19: " + expected + "'brick.png'"},
                 {fill + " brick.png 2\n", "3:19: " + expected + "'brick.png'"}});
}

TEST_CASE("hither and resolution may be missing") {
    BallFile file;
    CHECK(ballWarnings(file).empty());
    CHECK(parseNff(file.text(), "").width == 96);
    file.view = replaced(file.view, "hither 0.1\n", "");
    CHECK(ballWarnings(file).empty());
    CHECK(parseNff(file.text(), "").height == 96);
    file.resolution = "";
    CHECK(ballWarnings(file).empty());
    CHECK((parseNff(file.text(), "").width == 512 && parseNff(file.text(), "").height == 512));
    file.view += "hither 0.1\n";
    CHECK(ballWarnings(file).empty());
    CHECK((parseNff(file.text(), "").width == 512 && parseNff(file.text(), "").height == 512));
}
