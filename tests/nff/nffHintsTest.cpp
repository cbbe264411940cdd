#include "files.h"
#include "nff/field.h"

using namespace sw;
using namespace test;

namespace {

const std::string statementExpected = "expected a statement (v, b, l, f, s, c, p or pp), found ";

std::string hintOf(const std::string& text) {
    const std::string error = nffErrorOf(good + text);
    const std::size_t at = error.find(" (", error.find(", found "));
    return at == std::string::npos ? "" : error.substr(at + 1);
}

}  // namespace

TEST_CASE("characters that only look like the format's are named") {
    const auto [character, hint] = GENERATE(table<std::string, std::string>(
        {{"\xc2\xa0", "a no-break space, U+00A0: type a plain space"},
         {"\xe2\x80\xaf", "a narrow no-break space, U+202F: type a plain space"},
         {"\xe2\x80\x89", "a wide or narrow space, U+2009: type a plain space"},
         {"\xe3\x80\x80", "an ideographic space, U+3000: type a plain space"},
         {"\xe2\x88\x92", "a minus sign, U+2212: type a plain -"},
         {"\xe2\x80\x93", "an en dash, U+2013: type a plain -"},
         {"\xe2\x80\x94", "an em dash, U+2014: type a plain -"},
         {"\xe2\x80\x8b", "a zero width space, U+200B: delete it"},
         {"\xe2\x81\xa0", "a word joiner, U+2060: delete it"},
         {"\xef\xbb\xbf", "a byte order mark, U+FEFF: delete it"},
         {"\xef\xbc\x91", "a full-width character, U+FF11: type it plain"},
         {"\xc3\xa4", "the character U+00E4 is not plain text"},
         {"\xa0", "the byte 0xA0 is not plain text"},
         {"\xc2", "the byte 0xC2 is not plain text"},
         {"\xe2\x88", "the byte 0xE2 is not plain text"}}));
    CAPTURE(hint);
    const std::string marks(character.size(), '?');
    checkErrors({{"s 0 0 " + character + "1 2",
                  "3:7: expected a number, found '" + marks + "1' (" + hint + ")"},
                 {"s 0 0 1" + character + "1 2",
                  "3:7: expected a number, found '1" + marks + "1' (" + hint + ")"},
                 {character + "s 0 0 0 1",
                  "3:1: " + statementExpected + "'" + marks + "s' (" + hint + ")"}});
}

TEST_CASE("NaN and infinity as old Windows programs print them are refused") {
    const auto [number, meaning] =
        GENERATE(table<std::string, std::string>({{"1.#INF", "infinity"},
                                                  {"-1.#INF", "infinity"},
                                                  {"1.#INF00", "infinity"},
                                                  {"-1.#IND", "not a number"},
                                                  {"-1.#IND00", "not a number"},
                                                  {"1.#QNAN0", "not a number"},
                                                  {"1.#SNAN", "not a number"}}));
    const std::string found = ": expected a number, found '" + number + "' (" + meaning +
                              ", as old Windows programs print it)";
    checkErrors({{"s 0 0 0 " + number, "3:9" + found},
                 {"s 0 0 0 " + number + "\ns 0 0 0 1", "3:9" + found},
                 {"l 4 6 " + number, "3:7" + found},
                 {"l 4 6 5 " + number + " 1 1", "3:9" + found},
                 {"f 1 1 1 1 0 0 0 " + number + "\n", "3:17" + found},
                 {"p " + number, "3:3" + found}});
}

TEST_CASE("a # that touches a number is an error, elsewhere it begins a comment") {
    const std::string hint = "' (a comment needs a space before its #)";
    checkErrors({{"s 0 0 0 1#ball\n", "3:9: expected a number, found '1#ball" + hint},
                 {"s 0 0 0#1 1\n", "3:7: expected a number, found '0#1" + hint},
                 {"s 0 0 0 1 2#\n", "3:11: " + statementExpected + "'2#" + hint}});
    CHECK(nffErrorOf(good + "s#ball\n 0 0 0 1 # s\n#s\ns #\n1 1 1 1 #").empty());
}

TEST_CASE("numbers that stand glued together are named as that") {
    const std::string hint = "(numbers glued together: separate them by spaces)";
    for (const std::string glued : {"0.0780.3610.753", "0.20.3", "1-2", "-1.5-.5", "1e5.5", "1+2"})
        CHECK(hintOf("b " + glued + " 1 1") == hint);
    for (const std::string single : {"0x1", "1.5f", "1e", "--1", "1,5", "3.x", "-", ".", "1.2.x"})
        CHECK(hintOf("b " + single + " 1 1").empty());
}

TEST_CASE("too many numbers are counted") {
    const auto numbers = [](int count) {
        std::string list;
        for (int i = 0; i < count; ++i) list += " 1";
        return list;
    };
    const auto [keyword, size] = GENERATE(
        table<std::string, int>({{"b", 3}, {"l", 6}, {"f", 8}, {"s", 4}, {"number", 1}, {"g", 6}}));
    for (const int more : {1, 2, 30}) {
        const std::string text = "\n" + keyword + numbers(size);
        const std::string message = "4:" + std::to_string(text.size() + 1) + ": expected " +
                                    std::to_string(size) + (size == 1 ? " number" : " numbers") +
                                    " after '" + keyword + "', found " +
                                    std::to_string(size + more);
        checkErrors(
            {{text + numbers(more), message}, {text + numbers(more) + "\ns 0 0 0 1\n", message}});
    }
    checkErrors({{"p 3 0 0 0 1 0 0 1 1 0\n0 1 0\n", "4:1: expected 9 numbers after 'p', found 12"},
                 {"pp 3 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1\n7",
                  "4:1: expected 18 numbers after 'pp', found 19"},
                 {"c 0 0 0 1 0 0 1 1 9", "3:19: expected 8 numbers after 'c', found 9"}});
    const std::string start = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45";
    checkErrors(
        {{"v from 0 0 5 5 at 0 0 0", "1:14: expected 3 numbers after 'from', found 4"},
         {start + " 45 hither 1", "1:41: expected 1 number after 'angle', found 2"},
         {start + " resolution 8 8 8", "1:56: expected 2 numbers after 'resolution', found 3"}},
        "");
}

TEST_CASE("a name among the numbers is named, with what is missing before it") {
    const std::string place = "3:17: expected 8 numbers after 'f', found 7 before 'brick.png'";
    checkErrors(
        {{"f 1 1 1 1 0 0 0 brick.png", place + ": 1 is missing"},
         {"f 1 1 1 1 0 0 0 brick.png\ns 0 0 0 1\n", place + ": 1 is missing"},
         {"f 1 1 1 1 0 0 0 brick.png 1", "3:17: expected a number, found 'brick.png'"},
         {"b 1 red\n", "3:5: expected 3 numbers after 'b', found 1 before 'red': 2 are missing"}});
}

TEST_CASE("words of other dialects and formats are named") {
    CHECK(hintOf("pl 0 0 0 1 0 0 0 0 1") ==
          "(an infinite plane of another dialect: use a large polygon)");
    CHECK(hintOf("tess 4") == "(a word of assimp's dialect)");
    CHECK(hintOf("fm 0 0 0 1 1 1 1 1 1 1 1 1") == "(a material of BART's dialect: use 'f')");
    const auto whole = [](const std::string& file) {
        const std::string error = nffErrorOf(file);
        return error.substr(error.find(", found "));
    };
    CHECK(whole("nff\nversion 2.1\n") ==
          ", found 'nff' (Sense8's format, which only shares the name NFF)");
    CHECK(whole("\x89PNG\r\n\x1a\n") == ", found '?PNG' (this is a PNG picture)");
    CHECK(whole("camera { location <0,1,2> }") == ", found 'camera' (a POV-Ray file?)");
    CHECK(whole("# obj\nv 0 0 0\nv 1 0 0\n") == ", found '0' (a Wavefront OBJ file?)");
}

TEST_CASE("a picture is named as what it is") {
    const fs::path png = fs::path(SW_SCENES) / "cornell.png";
    CHECK(has(nffErrorOf(contentOf(png)), "(this is a PNG picture)"));
}
