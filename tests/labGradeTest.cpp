#include <algorithm>

#include "lab/report/json.h"
#include "labBuild.h"

using namespace test;

namespace {

// The text behind `"label": "NAME"` up to the end of that line.
std::string gradeOf(const std::string& json, const std::string& label) {
    const auto at = json.find("\"label\": \"" + label);
    REQUIRE(at != std::string::npos);
    return json.substr(at, json.find('\n', at) - at);
}

}  // namespace

TEST_CASE("points are in proportion to the passed tests, rounded down", "[lab]") {
    Build build;
    for (const char* name : {"a", "b", "c"}) build.add(recordOf(1, name, Verdict::passed));
    build.add(recordOf(2, "a", Verdict::passed));
    build.add(recordOf(2, "b", Verdict::passed));
    build.add(recordOf(2, "c", Verdict::failed));
    build.add(recordOf(3, "a", Verdict::passed));
    build.add(recordOf(3, "b", Verdict::unfinished));
    build.addUnrun(3, "c");
    build.addUnrun(4, "a");
    const std::string json = build.grade();
    const auto has = [&](const char* label, const std::string& numbers) {
        return contains(gradeOf(json, label), numbers);
    };
    CHECK(has("lab1-diffuse", R"("passed": 3, "tests": 3, "points": 10, "of": 10)"));
    CHECK(has("lab2-triangle", R"("passed": 2, "tests": 3, "points": 6, "of": 10)"));
    CHECK(has("lab3-shadows", R"("passed": 1, "tests": 3, "points": 3, "of": 10)"));
    CHECK(has("lab4-reflection",
              R"("passed": 0, "tests": 1, "points": 0, "of": 10, "note": "not run")"));
    CHECK(has("lab5-refraction",
              R"("passed": 0, "tests": 0, "points": 0, "of": 10, "note": "not run")"));
    CHECK(contains(json, R"("total": 19, "of": 60)"));
    CHECK(contains(json, R"({"test": "b", "verdict": "crashed")"));
    CHECK(contains(json, R"({"test": "c", "verdict": "failed")"));
    CHECK(contains(json, R"({"test": "c", "verdict": "not run")"));
}

TEST_CASE("full points are for those alone who passed all tests", "[lab]") {
    Build build;
    for (int i = 0; i < 99; ++i) build.add(recordOf(1, std::to_string(i), Verdict::passed));
    build.add(recordOf(1, "the last", Verdict::failed));
    CHECK(contains(build.grade("1,0,0,0,0,0"), R"("total": 0, "of": 1)"));
    CHECK(contains(build.grade("100,0,0,0,0,0"), R"("total": 99, "of": 100)"));
    CHECK(contains(build.grade("1000000,2,3,4,5,6"), R"("total": 990000, "of": 1000020)"));
}

TEST_CASE("what ran before the last build gives no points", "[lab]") {
    Build build;
    build.add(recordOf(1, "a", Verdict::passed));
    CHECK(contains(build.grade(), R"("total": 10)"));
    build.buildAgain();
    const std::string json = build.grade();
    CHECK(contains(json, R"("total": 0)"));
    CHECK(contains(gradeOf(json, "lab1"), R"("passed": 0, "tests": 1)"));
    CHECK(contains(gradeOf(json, "lab1"), R"("note": "not run")"));
}

TEST_CASE("without the program that runs the tests nothing has run", "[lab]") {
    Build build;
    build.add(recordOf(1, "a", Verdict::passed));
    fs::remove(build.program());
    CHECK(contains(build.grade(), R"("total": 0)"));
}

TEST_CASE("a hint is part of the grade", "[lab]") {
    Build build;
    Record record = recordOf(1, "a \"sphere\"", Verdict::failed);
    record.hint = "line\nline";
    build.add(record);
    CHECK(contains(build.grade(),
                   R"({"test": "a \"sphere\"", "verdict": "failed", "hint": "line\nline"})"));
}

TEST_CASE("in a JSON string are no control characters, and all quotes are escaped", "[lab]") {
    const auto seed = GENERATE(range(0u, 200u));
    const std::string json = lab::jsonString(anyText(seed));
    CAPTURE(seed, json);
    std::size_t i = 1;
    for (; i < json.size() && json[i] != '"'; ++i) {
        CHECK(static_cast<unsigned char>(json[i]) >= 0x20);
        if (json[i] == '\\') CHECK(std::string("\"\\nu").find(json[++i]) != std::string::npos);
    }
    CHECK(json[0] == '"');
    CHECK(i == json.size() - 1);
}

TEST_CASE("what is no UTF-8 is replaced in a JSON string", "[lab]") {
    const auto text = [](const char* bytes, std::size_t size) {
        return lab::jsonString(std::string(bytes, size));
    };
    CHECK(lab::jsonString("") == "\"\"");
    CHECK(lab::jsonString("a\"b\\c\n\x01\x1f\x7f") == "\"a\\\"b\\\\c\\n\\u0001\\u001f\x7f\"");
    CHECK(text("\0", 1) == "\"\\u0000\"");
    for (const std::string good : {"\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x98\x80",
                                   "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf", "\xee\x80\x80"})
        CHECK(lab::jsonString(good) == "\"" + good + "\"");
    // Alone, cut off, longer than need be, a surrogate, beyond U+10FFFF.
    const std::string bad = "\\ufffd";
    CHECK(lab::jsonString("\x80") == "\"" + bad + "\"");
    CHECK(lab::jsonString("\xc3") == "\"" + bad + "\"");
    CHECK(lab::jsonString("\xe2\x82") == "\"" + bad + bad + "\"");
    CHECK(lab::jsonString("\xc0\xaf") == "\"" + bad + bad + "\"");
    CHECK(lab::jsonString("\xe0\x80\xaf") == "\"" + bad + bad + bad + "\"");
    CHECK(lab::jsonString("\xed\xa0\x80") == "\"" + bad + bad + bad + "\"");
    CHECK(lab::jsonString("\xf4\x90\x80\x80") == "\"" + bad + bad + bad + bad + "\"");
    CHECK(lab::jsonString("\xc3\"x") == "\"" + bad + "\\\"x\"");
}

TEST_CASE("lab_report used wrongly says how it is used", "[lab]") {
    const auto run = [](const std::vector<std::string>& arguments) {
        std::ostringstream out, err;
        CHECK(lab::reportProgram(arguments, out, err) == 2);
        CHECK(out.str() == "");
        return err.str();
    };
    CHECK(contains(run({}), "page RECORDS PROGRAM PAGE"));
    CHECK(contains(run({"page", "a", "b"}), "page RECORDS PROGRAM PAGE"));
    CHECK(contains(run({"mark", "a", "b", "c"}), "page RECORDS PROGRAM PAGE"));
    const TemporaryFolder folder;
    const std::string file = (folder / "g.json").string();
    for (const char* points :
         {"", "10", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,5,", "1,2,3,4,5,-6", "1,2,3,4,5,6,",
          "1;2;3;4;5;6", "1,2,3,4,5,1.5", "1,2,3,4,5,1000001", "1,2,3,4,5,99999999999"}) {
        CAPTURE(points);
        CHECK(contains(run({"grade", "a", "b", file, points}), "expected six whole numbers"));
    }
    CHECK(folder.count() == 0);
}

TEST_CASE("a report that cannot be written is one line of error", "[lab]") {
    const TemporaryFolder folder;
    std::ostringstream out, err;
    makeFile(folder / "file", "");
    CHECK(lab::reportProgram({"page", "a", "b", (folder / "file" / "x" / "index.html").string()},
                             out, err) == 1);
    CHECK(lab::reportProgram(
              {"grade", "a", "b", (folder / "none" / "g.json").string(), "1,2,3,4,5,6"}, out,
              err) == 1);
    CHECK(out.str() == "");
    const std::string text = err.str();
    CHECK(std::count(text.begin(), text.end(), '\n') == 2);
}
