#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/report/labBuild.h"

using namespace test;

namespace {

using Json = nlohmann::json;

Json gradeOf(Build& build, const std::string& points = "10,10,10,10,10,10") {
    return Json::parse(build.grade(points));
}

// A task's passed tests, all tests, points, and points to be had.
std::vector<int> numbersOf(const Json& grade, int task) {
    const Json& object = grade["tasks"][static_cast<std::size_t>(task - 1)];
    return {object["passed"], object["tests"], object["points"], object["of"]};
}

bool hasRun(const Json& grade, int task) {
    return !grade["tasks"][static_cast<std::size_t>(task - 1)].contains("note");
}

// A grade whose only hint is the text, and that hint as a reader of JSON finds it.
std::string hintIn(const std::string& text) {
    Build build;
    Record record = recordOf(1, "a", Verdict::failed);
    record.hint = text;
    build.add(record);
    return gradeOf(build)["tasks"][0]["failed"][0]["hint"];
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
    const Json grade = gradeOf(build);
    CHECK(numbersOf(grade, 1) == std::vector{3, 3, 10, 10});
    CHECK(numbersOf(grade, 2) == std::vector{2, 3, 6, 10});
    CHECK(numbersOf(grade, 3) == std::vector{1, 3, 3, 10});
    CHECK(numbersOf(grade, 4) == std::vector{0, 1, 0, 10});
    CHECK(numbersOf(grade, 5) == std::vector{0, 0, 0, 10});
    for (int task = 1; task <= 6; ++task) CHECK(hasRun(grade, task) == (task <= 3));
    CHECK(grade["tasks"][1]["label"] == "lab2-triangle");
    CHECK(grade["total"] == 19);
    CHECK(grade["of"] == 60);
    CHECK(grade["tasks"][1]["failed"][0]["test"] == "c");
    CHECK(grade["tasks"][1]["failed"][0]["verdict"] == "failed");
    CHECK(grade["tasks"][2]["failed"][0]["verdict"] == "crashed");
    CHECK(grade["tasks"][2]["failed"][1]["verdict"] == "not run");
}

TEST_CASE("full points are for those alone who passed all tests", "[lab]") {
    Build build;
    for (int i = 0; i < 99; ++i) build.add(recordOf(1, std::to_string(i), Verdict::passed));
    build.add(recordOf(1, "the last", Verdict::failed));
    const auto total = [&](const char* points) { return gradeOf(build, points)["total"]; };
    CHECK(total("1,0,0,0,0,0") == 0);
    CHECK(total("100,0,0,0,0,0") == 99);
    CHECK(total("1000000,2,3,4,5,6") == 990000);
    CHECK(gradeOf(build, "1000000,2,3,4,5,6")["of"] == 1000020);
}

TEST_CASE("what ran before the last build gives no points", "[lab]") {
    Build build;
    build.add(recordOf(1, "a", Verdict::passed));
    CHECK(gradeOf(build)["total"] == 10);
    build.buildAgain();
    const Json grade = gradeOf(build);
    CHECK(grade["total"] == 0);
    CHECK(numbersOf(grade, 1) == std::vector{0, 1, 0, 10});
    CHECK_FALSE(hasRun(grade, 1));
}

TEST_CASE("without the program that runs the tests nothing has run", "[lab]") {
    Build build;
    build.add(recordOf(1, "a", Verdict::passed));
    fs::remove(build.program());
    CHECK(gradeOf(build)["total"] == 0);
}

TEST_CASE("a hint is part of the grade, whatever its characters", "[lab]") {
    for (const std::string good : {"", "line\nline", "a\"b\\c\n\x01\x1f\x7f", "\xc3\xa9",
                                   "\xe2\x82\xac", "\xf0\x9f\x98\x80"})
        CHECK(hintIn(good) == good);
    // Alone, cut off, longer than need be, a surrogate, beyond U+10FFFF.
    for (const std::string bad :
         {"\x80", "\xc3", "\xe2\x82", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"})
        CHECK(contains(hintIn(bad), "\xef\xbf\xbd"));
}

TEST_CASE("a grade is JSON whatever the bytes of a hint", "[lab]") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    CHECK_NOTHROW(hintIn(anyText(seed)));
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
