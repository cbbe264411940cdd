#include "files.h"
#include "nff/nff.h"

using namespace sw;
using namespace test;

namespace {

const std::string statementExpected = "expected a statement (v, b, l, f, s, c, p or pp), found ";

}  // namespace

TEST_CASE("missing numbers are reported where they are missing") {
    const std::string light = " (x y z r g b, or x y z alone)";
    const std::string material = " (r g b Kd Ks Shine T index)";
    checkErrors({
        {"b 1 1\nl 0 0 0", "3:6: expected 3 numbers after 'b', found 2: 1 is missing (r g b)"},
        {"l 0\nb 0 0 0", "3:4: expected 3 numbers after 'l', found 1: 2 are missing (x y z)"},
        {"l 0 0 0 1\nb 0 0 0",
         "3:10: expected 6 numbers after 'l', found 4: 2 are missing" + light},
        {"l 0 0 0 1 1 # dim\nb 0 0 0",
         "3:12: expected 6 numbers after 'l', found 5: 1 is missing" + light},
        {"s 0 0 0\ns 0 0 0 1",
         "3:8: expected 4 numbers after 's', found 3: 1 is missing (x y z radius)"},
        {"f 1 1 1 1 0 0 0\ns 0 0 0 1",
         "3:16: expected 8 numbers after 'f', found 7: 1 is missing" + material},
        {"f 1 1 1 1 0\ns 0 0 0 1",
         "3:12: expected 8 numbers after 'f', found 5: 3 are missing" + material},
        {"\n\n  f\ns 0 0 0 1", "5:4: expected 8 numbers after 'f', found 0" + material},
        {"p\ns 0 0 0 1", "3:2: expected 1 number after 'p', found 0"},
        {"p 3\n0 0 0\n1 0 0\n1 1\ns 0 0 0 1",
         "6:4: expected 9 numbers after 'p', found 8: 1 is missing (a polygon has three numbers "
         "per vertex)"},
        {"c 0 0 0 1\n0 1 0\ns 0 0 0 1",
         "4:6: expected 8 numbers after 'c', found 7: 1 is missing (base and apex, each a point "
         "and a radius)"},
        {"pp 3 0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0\ns 0 0 0 1",
         "5:6: expected 18 numbers after 'pp', found 15: 3 are missing (a patch has six numbers "
         "per vertex)"},
        {"p 4 0 0 0 1 0 0 1 1 0\npp 3",
         "3:22: expected 12 numbers after 'p', found 9: 3 are missing (a polygon has three numbers "
         "per vertex)"},
    });
}

TEST_CASE("a file that ends too early is reported at its end") {
    const std::string end = " and the end of the file";
    checkErrors({
        {"b 1 1", "3:6: expected 3 numbers after 'b', found 2" + end + ": 1 is missing (r g b)"},
        {"b 1 1 \n\n # comment",
         "3:6: expected 3 numbers after 'b', found 2" + end + ": 1 is missing (r g b)"},
        {"l", "3:2: expected 3 numbers after 'l', found 0" + end + " (x y z)"},
        {"l 0 0 0 1 1", "3:12: expected 6 numbers after 'l', found 5" + end +
                            ": 1 is missing (x y z r g b, or x y z alone)"},
        {"s 0 0 0",
         "3:8: expected 4 numbers after 's', found 3" + end + ": 1 is missing (x y z radius)"},
        {"p", "3:2: expected 1 number after 'p', found 0" + end},
        {"p 10000 0 0 0", "3:14: expected 30000 numbers after 'p', found 3" + end +
                              ": 29997 are missing (a polygon has three numbers per vertex)"},
        {"p 3 0 0 0", "3:10: expected 9 numbers after 'p', found 3" + end +
                          ": 6 are missing (a polygon has three numbers per vertex)"},
    });
    checkErrors(
        {{"v", "1:2: expected 'from' in the view, found the end of the file"},
         {"v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 8",
          "1:62: expected 2 numbers after 'resolution', found 1" + end + ": 1 is missing"},
         {"v from 1 2", "1:11: expected 3 numbers after 'from', found 2" + end + ": 1 is missing"},
         {"v\nfrom 1 2 3\n\n", "2:11: expected 'at' in the view, found the end of the file"}},
        "");
}

TEST_CASE("words in place of numbers are reported where they are") {
    const std::string start = "3:7: expected a number, found ";
    checkErrors({
        {"s 0 0 zero 1", start + "'zero'"},
        {"s 0 0 1,5 1", start + "'1,5'"},
        {"s 0 0 1.5f 1", start + "'1.5f'"},
        {"s 0 0 0x1 1", start + "'0x1'"},
        {"s 0 0 1e 1", start + "'1e'"},
        {"s 0 0 --1 1", start + "'--1'"},
        {"s 0 0 +-1 1", start + "'+-1'"},
        {"s 0 0 ++1 1", start + "'++1'"},
        {"s 0 0 - 1", start + "'-'"},
        {"s 0 0 + 1", start + "'+'"},
        {"s 0 0 . 1", start + "'.'"},
        {"s 0 0 S 1", start + "'S'"},
        {"p 3.x", "3:3: expected a number, found '3.x'"},
    });
}

TEST_CASE("numbers must be finite") {
    const auto spelling = GENERATE(as<std::string>(), "nan", "-nan", "NaN", "inf", "+inf", "-INF",
                                   "infinity", "1e39", "-1e39", "1e400", "3.5e38");
    const std::string message = ": expected a finite number, found '" + spelling + "'";
    checkErrors({{"s 0 " + spelling + " 0 1", "3:5" + message},
                 {"\t\tb " + spelling + " 0 0", "3:5" + message},
                 {"p " + spelling, "3:3" + message}});
}

TEST_CASE("unknown statements are reported where they are") {
    checkErrors({
        {"sphere 0 0 0 1", "3:1: " + statementExpected + "'sphere'"},
        {"S 0 0 0 1", "3:1: " + statementExpected + "'S'"},
        {"s 0 0 0 1 - 2", "3:11: " + statementExpected + "'-'"},
        {"  from 0 0 0", "3:3: " + statementExpected + "'from'"},
        {"// comment", "3:1: " + statementExpected + "'//'"},
    });
}

TEST_CASE("found text is shown short and printable") {
    checkErrors(
        {{std::string(24, 'x'), "3:1: " + statementExpected + "'" + std::string(24, 'x') + "'"},
         {std::string(25, 'x'), "3:1: " + statementExpected + "'" + std::string(24, 'x') + "...'"},
         {"a\x1b[31m\xff~",
          "3:1: " + statementExpected + "'a?[31m?~' (the character U+001B is not plain text)"},
         {std::string("a\0b", 3),
          "3:1: " + statementExpected + "'a?b' (a NUL byte, U+0000: is this a text file?)"}});
}

TEST_CASE("values out of range are reported where they are") {
    const std::string vertices =
        "3:3: expected a number of vertices from 3 to 10000 (split larger polygons), found ";
    const std::string negative = "3:2: expected Kd, Ks and T of 0 or more, found a negative one";
    const std::string index = "expected a positive index of refraction, as T is positive, found ";
    checkErrors({
        {"s 0 0 0 0", "3:9: expected a radius other than 0, found '0'"},
        {"s 0 0 0\n -0", "4:2: expected a radius other than 0, found '-0'"},
        {"s 0 0 0 1e-60", "3:9: expected a radius other than 0, found '1e-60'"},
        {"p 2 0 0 0 1 1 1", vertices + "'2'"},
        {"p 3.5", vertices + "'3.5'"},
        {"p 10001", vertices + "'10001'"},
        {"p 1e7", vertices + "'1e7'"},
        {"p -4", vertices + "'-4'"},
        {"p 999999999 0 0 0", vertices + "'999999999'"},
        {"pp 999999999 0 0 0", "3:4" + vertices.substr(3) + "'999999999'"},
        {" f 1 1 1 -0.1 0 0 0 1", negative},
        {" f 1 1 1 1 -0.1 0 0 1", negative},
        {" f 1 1 1 1 0 0 -0.1 1", negative},
        {"c 0 0 0 1  0 0 1 -2", "3:18: expected two radii of the same sign, found '-2'"},
        {"c 0 0 0 -1  0 0 1 1e-9", "3:19: expected two radii of the same sign, found '1e-9'"},
        {"c 0 0 0 0  0 0 1 0",
         "3:18: expected a radius other than 0 at one end at least, found '0'"},
        {"f 1 1 1 0 0 0 1 0", "3:17: " + index + "'0'"},
        {"f 1 1 1 0 0 0 1 -1.3", "3:17: " + index + "'-1.3'"},
    });
}

TEST_CASE("a view that is incomplete or out of order is an error") {
    const std::string full =
        "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 8\n";
    const std::vector<std::string> words = {"from", "at", "up", "angle"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string line = std::to_string(i + 2);
        std::string text = full;
        text.replace(text.find("\n" + words[i]) + 1, words[i].size(), "oops");
        checkErrors({{text, line + ":1: expected '" + words[i] + "' in the view, found 'oops'"}},
                    "");
    }
}

TEST_CASE("a view that makes no sense is an error") {
    const auto with = [](const std::string& from, const std::string& up, const std::string& angle,
                         const std::string& resolution) {
        return "\n v from " + from + " at 1 2 3 up " + up + "\nangle " + angle +
               " hither 1 resolution " + resolution;
    };
    const std::string up =
        "2:2: expected 'up' to point across the view, found it zero or along the view";
    const std::string angle = "3:7: expected an angle between 0 and 180 degrees, found ";
    const std::string size = ": expected a width and a height from 1 to 16384, found ";
    checkErrors({{with("1 2 3", "0 1 0", "45", "8 8"),
                  "2:2: expected 'from' and 'at' to differ, found the same point"},
                 {with("0 0 0", "0 0 0", "45", "8 8"), up},
                 {with("0 0 0", "1 2 3", "45", "8 8"), up},
                 {with("0 0 0", "-10 -20 -30", "45", "8 8"), up},
                 {with("0 0 0", "0 1 0", "0", "8 8"), angle + "'0'"},
                 {with("0 0 0", "0 1 0", "-45", "8 8"), angle + "'-45'"},
                 {with("0 0 0", "0 1 0", "180", "8 8"), angle + "'180'"}},
                "");
    for (const std::string bad : {"0", "-1", "8.5", "16385", "1e9"}) {
        const std::string found = size + "'" + bad + "'";
        checkErrors({{with("0 0 0", "0 1 0", "45", bad + " 8"), "3:30" + found},
                     {with("0 0 0", "0 1 0", "45", "8 " + bad), "3:32" + found}},
                    "");
    }
    CHECK(nffErrorOf(with("0 0 0", "0 1 0", "0.001", "1 1")).empty());
    CHECK(nffErrorOf(with("0 0 0", "0 1 0", "179.99", "16384 16384")).empty());
}

TEST_CASE("a second view is an error") {
    checkErrors({{"\n  " + good, "4:3: expected one view, found a second 'v'"}});
    const std::string message = "expected a view ('v') in the file, found none";
    checkErrors({{"", "1:1: " + message},
                 {"\n # comment\n", "1:1: " + message},
                 {"b 0 0 0\nl 1 2 3\n# the end\n", "2:8: " + message}},
                "");
}

TEST_CASE("objects need a material before them") {
    const std::string message = "expected a material ('f') before the first object, found none";
    checkErrors({{"b 0 0 0\n s 0 0 0 1\nf 1 1 1 1 0 0 0 1", "2:2: " + message},
                 {"p 3 0 0 0 1 0 0 1 1 0", "1:1: " + message}},
                "");
}

TEST_CASE("lines and columns count from one whatever comes before") {
    Random random(GENERATE(range(0u, 200u)));
    const std::string pieces[] = {"\n",        "\r\n",    "\r",      " ",        "\t",
                                  "# x y\r\n", "# x y\r", "# x y\n", "b 0 0 0 ", "l 1 2 3\n"};
    std::string text = good;
    for (int i = random.whole(0, 30); i > 0; --i) text += pieces[random.whole(0, 9)];
    int line = 1, column = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        ++column;
        const bool isSecondHalf = text[i] == '\n' && text[i - 1] == '\r';
        if (text[i] == '\n' || text[i] == '\r') line += !isSecondHalf, column = 1;
    }
    CAPTURE(text);
    CHECK(nffErrorOf(text + "oops") == "a.nff:" + std::to_string(line) + ":" +
                                           std::to_string(column) + ": " + statementExpected +
                                           "'oops'");
}

TEST_CASE("a byte order mark takes no column") {
    CHECK(nffErrorOf("\xef\xbb\xbf"
                     "oops") == "a.nff:1:1: " + statementExpected + "'oops'");
}

TEST_CASE("a scene file that cannot be read is an error of the whole file") {
    const TemporaryFolder folder;
    const auto messageOf = [](const fs::path& path) {
        try {
            loadNff(path);
        } catch (const NffError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(messageOf(folder / "none.nff") ==
          (folder / "none.nff").string() + ": not found; is the path right?");
    CHECK(messageOf(folder.path) == folder.path.string() + ": is a folder; expected a file");
    makeFile(folder / "bad.nff", "\nbad");
    CHECK(messageOf(folder / "bad.nff") ==
          (folder / "bad.nff").string() + ":2:1: " + statementExpected + "'bad'");
}
