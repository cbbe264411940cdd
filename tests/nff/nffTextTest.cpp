#include "nff/field.h"

using namespace sw;
using namespace test;

namespace {

// The text in units of some bytes, behind a mark if it is to have one.
std::string encoded(const std::u32string& text, std::size_t unit, bool bigEndian, bool mark) {
    std::string bytes;
    const auto put = [&](char32_t value) {
        for (std::size_t i = 0; i < unit; ++i)
            bytes += static_cast<char>(value >> 8 * (bigEndian ? unit - 1 - i : i) & 0xFF);
    };
    if (mark) put(0xFEFF);
    for (const char32_t c : text) {
        if (unit == 4 || c < 0x10000) {
            put(c);
        } else {
            put(0xD800 + ((c - 0x10000) >> 10));
            put(0xDC00 + ((c - 0x10000) & 0x3FF));
        }
    }
    return bytes;
}

std::u32string wide(const std::string& ascii) {
    return {ascii.begin(), ascii.end()};
}

// What the reader says about the text in each encoding of two or four bytes.
std::vector<std::string> errorsIn(const std::u32string& text) {
    std::vector<std::string> errors;
    for (const std::size_t unit : {2u, 4u})
        for (const bool bigEndian : {false, true})
            for (const bool mark : {false, true})
                errors.push_back(nffErrorOf(encoded(text, unit, bigEndian, mark)));
    return errors;
}

}  // namespace

TEST_CASE("LF, CRLF and a lone CR each end a line and a comment") {
    const std::string end = GENERATE("\n", "\r\n", "\r");
    const std::string comment = GENERATE("", " # note", " # s 9 9 9 9", " #");
    const std::string first = GENERATE("", "# a room\n");
    const std::string text = replaced(first + BallFile().text(), "\n", comment + end);
    CHECK(isBallScene(parseNff(text, "a.nff")));
    CHECK(parseNff(text, "a.nff").warnings.empty());
}

TEST_CASE("line ends may be mixed") {
    Random random(GENERATE(range(0u, 50u)));
    std::string text;
    for (const char c : BallFile().text()) {
        const std::string ends[] = {"\n", "\r\n", "\r", " # ball\r", " # ball\r\n"};
        text += c == '\n' ? ends[random.whole(0, 4)] : std::string(1, c);
    }
    CHECK(isBallScene(parseNff(text, "a.nff")));
}

TEST_CASE("an error's line is counted by CRs as well, and so are shapes' lines") {
    const std::string end = GENERATE("\n", "\r\n", "\r", " # x\r\r", "\n\r");
    const int lines = end == "\n\r" || end == " # x\r\r" ? 2 : 1;
    BallFile file;
    file.floor = replaced(file.floor, "-4 -1 -4", "-4 -1 oops");
    CHECK(has(nffErrorOf(replaced(file.text(), "\n", end)),
              "a.nff:" + std::to_string(16 * lines + 1) + ":7: expected 12 numbers after 'p'"));
    std::vector<NffShape> shapes;
    parseNff(replaced(BallFile().text(), "\n", end), "a.nff", &shapes);
    REQUIRE(shapes.size() == 3);
    CHECK(shapes[0].line == 10 * lines + 1);
    CHECK(shapes[1].line == 12 * lines + 1);
}

TEST_CASE("files in UTF-16 and UTF-32 are read, with a byte order mark and without") {
    const std::size_t unit = GENERATE(2u, 4u);
    const bool bigEndian = GENERATE(false, true), mark = GENERATE(false, true);
    const std::string end = GENERATE("\n", "\r\n");
    const std::string text = replaced(BallFile().text(), "\n", " # plain" + end);
    std::u32string commented;
    for (const char c : text) {
        commented += static_cast<unsigned char>(c);
        if (c == '#') commented += U"\u00e4\u20ac\U0001F600";
    }
    CAPTURE(unit, bigEndian, mark);
    CHECK(isBallScene(parseNff(encoded(commented, unit, bigEndian, mark), "a.nff")));
}

TEST_CASE("an error in UTF-16 or UTF-32 has the line and column of its characters") {
    for (const std::string& error : errorsIn(wide("# x\r\n  oops")))
        CHECK(startsWith(error, "a.nff:2:3: expected a statement"));
    for (const std::string& error : errorsIn(wide(good) + U"s 0 0 \u22121 1"))
        CHECK(error ==
              "a.nff:3:7: expected a number, found '???1' (a minus sign, U+2212: type a plain -)");
}

TEST_CASE("half characters of UTF-16 and UTF-32 are refused") {
    for (const std::u32string bad : {U"s 0 0 0 \xD800 1", U"s 0 0 0 \xDC00 1"})
        for (const std::string& error : errorsIn(wide(good) + bad))
            CHECK(has(error, "3:9: expected a number"));
    for (const std::size_t unit : {2u, 4u}) {
        const std::string text = encoded(wide(good + "s 0 0 0 1\n"), unit, false, true);
        CHECK(nffErrorOf(text).empty());
        for (std::size_t cut = 1; cut < unit; ++cut)
            CHECK(has(nffErrorOf(text.substr(0, text.size() - cut)), "an unreadable character"));
    }
}

TEST_CASE("a Ctrl-Z ends a file of DOS days, and nothing else") {
    CHECK(isBallScene(parseNff(BallFile().text() + "\x1a", "a.nff")));
    CHECK(isBallScene(parseNff(BallFile().text() + "\x1a\x1a\x1a", "a.nff")));
    CHECK(has(nffErrorOf(good + "\x1a\ns 0 0 0 1"), "3:1: expected a statement"));
    CHECK(has(nffErrorOf(good + "s 0 0 \x1a 0 1"), "'?' (a Ctrl-Z, U+001A: delete it)"));
}
