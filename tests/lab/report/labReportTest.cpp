#include <regex>

#include "lab/report/labBuild.h"
#include "png.h"
#include "swImage.h"
#include "tools/common/html.h"

using namespace test;

namespace {

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

// A record with the pictures it tells of.
Record pictureRecord(const Build& build) {
    Record record = recordOf(3, "a picture", Verdict::failed);
    record.pictures = {{"ball", "ball-e.png", "ball-g.png", "ball-d.png", 12, 34, 56}};
    fs::create_directories(build.records());
    for (const char* file : {"ball-e.png", "ball-g.png", "ball-d.png"})
        sw::writePng(sw::Image(96, 96), build.records() / file);
    return record;
}

}  // namespace

TEST_CASE("the page of a lab that has not begun says so for all six tasks", "[lab]") {
    const Build build;
    const std::string page = build.page();
    CHECK(count(page, "not run yet</span>") == 12);  // at a glance, and in each section
    CHECK(contains(page, "0 of 6 tasks pass."));
    CHECK(contains(page, "No test has run yet"));
    CHECK_FALSE(contains(page, "class=\"failed\""));
}

TEST_CASE("the page shows each verdict, at a glance and in its section", "[lab]") {
    Build build;
    build.add(recordOf(1, "one", Verdict::passed));
    build.add(recordOf(1, "two", Verdict::passed));
    build.add(recordOf(2, "three", Verdict::failed));
    build.add(recordOf(2, "four", Verdict::passed));
    build.add(recordOf(3, "five", Verdict::unfinished));
    build.add(recordOf(4, "six", Verdict::passed));
    build.addUnrun(4, "seven");
    const std::string page = build.page();
    CHECK(count(page, "passed 2 of 2 tests<") == 2);
    CHECK(count(page, "failed 1 of 2 tests<") == 2);
    CHECK(count(page, "failed 1 of 1 test<") == 2);
    CHECK(count(page, "passed 1 of 2 tests, 1 not run<") == 2);
    CHECK(count(page, "not run yet</span>") == 4);
    CHECK(contains(page, "1 of 6 tasks pass."));
    CHECK(std::regex_search(page, std::regex("Last test run: \\d\\d \\w+ \\d{4}, \\d\\d:\\d\\d")));
}

TEST_CASE("all tasks passed is a reason to be glad", "[lab]") {
    Build build;
    for (int task = 1; task <= 6; ++task) build.add(recordOf(task, "a", Verdict::passed));
    CHECK(contains(build.page(), "All 6 tasks pass."));
}

TEST_CASE("the page tells how a test ended before its time", "[lab]") {
    struct End {
        std::string noted, told, verdict;
    };
    for (const End& end :
         {End{"signal\nSIGFPE - Math error\ntraceRay()",
              "The program crashed while traceRay() was running: SIGFPE - Math error", "crashed"},
          End{"recursion\nSIGSEGV\n", "The stack is full: a function calls itself without end",
              "endless recursion"},
          End{"exit\n\nsamplePixel()", "The program called exit() while samplePixel() was running.",
              "called exit()"},
          End{"time\n\n", "This test was stopped as it took too long:", "took too long"},
          End{"", "did not come to its end, and nothing is known about why", "crashed"}}) {
        Build build;
        const Record record = recordOf(4, "a mirror", Verdict::unfinished);
        build.add(record);
        if (!end.noted.empty()) makeFile(lab::endFile(record, build.records()), end.noted);
        CAPTURE(end.noted);
        CHECK(contains(build.page(), end.told));
        CHECK(contains(build.grade(), "\"verdict\": \"" + end.verdict + "\""));
    }
}

TEST_CASE("a test that took long has a word on the page and keeps its points", "[lab]") {
    Build build;
    Record slow = recordOf(6, "slow one", Verdict::passed),
           quick = recordOf(6, "b", Verdict::passed);
    slow.seconds = 5.2;
    quick.seconds = 0.3;
    build.add(slow);
    build.add(quick);
    CHECK(contains(build.page(), "<li>slow one: 5 s</li>"));
    CHECK_FALSE(contains(build.page(), "<li>b: "));
    CHECK(contains(build.grade(), "\"total\": 10"));
}

TEST_CASE("how an earlier run ended is forgotten", "[lab]") {
    Build build;
    Record record = recordOf(4, "a mirror", Verdict::passed);
    build.add(record);
    makeFile(lab::endFile(record, build.records()), "exit\n\n");
    CHECK_FALSE(contains(build.page(), "exit()"));
}

TEST_CASE("a failed test's lesson stands on the page, whatever it holds", "[lab]") {
    const auto seed = GENERATE(range(0u, 50u));
    CAPTURE(seed);
    Build build;
    Record record = recordOf(1, "<script>alert('x')</script>" + anyText(seed), Verdict::failed);
    record.tried = "<img src=\"http://x\">" + anyText(seed + 100);
    record.got = "</section>" + anyText(seed + 200);
    record.expected = "<!--" + anyText(seed + 300);
    record.hint = "a < b & \"c\"" + anyText(seed + 400);
    build.add(record);
    const std::string page = build.page();
    for (const std::string& text :
         {record.test, record.tried, record.got, record.expected, record.hint})
        CHECK(contains(page, html::escaped(text) + "<"));
    CHECK_FALSE(contains(page, "<script"));
    CHECK_FALSE(contains(page, "<img"));
    CHECK_FALSE(contains(page, "<!--"));
    CHECK(count(page, "</section>") == 6);
}

TEST_CASE("tests that would repeat a hint are folded behind the first", "[lab]") {
    Build build;
    for (const char* name : {"a", "b", "c", "d"}) {
        Record record = recordOf(2, name, Verdict::failed);
        record.hint = name[0] == 'b' ? "other" : "same";
        build.add(record);
    }
    Record picture = pictureRecord(build);
    picture.hint = "same";
    build.add(picture);
    const std::string page = build.page();
    const auto fold = page.find("<details><summary>2 more tests: the same</summary>");
    const auto foldEnd = page.find("</details>", fold);
    REQUIRE(foldEnd != std::string::npos);
    const auto place = [&](const std::string& name) {
        return page.find("</span> " + name + "</h3>");
    };
    CHECK(place("a") < fold);
    for (const char* repeating : {"c", "d"})
        CHECK((place(repeating) > fold && place(repeating) < foldEnd));
    CHECK((place("b") > foldEnd && place("b") < page.size()));
    CHECK((place("a picture") > foldEnd && place("a picture") < page.size()));
    CHECK(count(page, "tests: the same") == 1);
}

TEST_CASE("a note on a passed test stands behind its name", "[lab]") {
    Build build;
    Record record = recordOf(6, "counts rays", Verdict::passed);
    record.got = "right but slow";
    build.add(record);
    CHECK(contains(build.page(), "<li>counts rays: right but slow</li>"));
}

TEST_CASE("what is told of a passed test is folded away", "[lab]") {
    Build build;
    build.add(recordOf(2, "hits the middle", Verdict::passed));
    const std::string page = build.page();
    CHECK(std::regex_search(page, std::regex("<details><summary>1 test passed</summary>\\s*<ul>"
                                             "\\s*<li>hits the middle")));
}

TEST_CASE("pictures are inside the page, with a ring around the worst pixel", "[lab]") {
    Build build;
    build.add(pictureRecord(build));
    const std::string page = build.page();
    CHECK(count(page, "<img ") == 3);
    CHECK(count(page, "src=") == 3);
    CHECK(count(page, "src=\"data:image/png;base64,") == 3);
    CHECK_FALSE(contains(page, "http"));
    CHECK_FALSE(contains(page, "<script"));
    CHECK_FALSE(contains(page, "url("));
    // The middle of pixel (12, 34) of 96: 12.5 / 96 and 34.5 / 96.
    CHECK(count(page, "class=\"ring\" style=\"left:13.0%;margin-top:35.9%\"") == 3);
    CHECK(contains(page, "56 of 255, in pixel (12, 34)"));
    for (const char* caption : {"expected", "yours", "difference, amplified"})
        CHECK(contains(page, "<figcaption>" + std::string(caption) + "</figcaption>"));
}

TEST_CASE("a picture without a difference has no ring", "[lab]") {
    Build build;
    Record record = pictureRecord(build);
    record.pictures[0].steps = 0;
    record.verdict = Verdict::passed;
    build.add(record);
    const std::string page = build.page();
    CHECK(count(page, "<img ") == 3);
    CHECK_FALSE(contains(page, "class=\"ring\""));
    CHECK(contains(page, "The same in every pixel."));
}

TEST_CASE("a picture that is missing leaves the rest of the page as it is", "[lab]") {
    Build build;
    build.add(pictureRecord(build));
    fs::remove(build.records() / "ball-g.png");
    makeFile(build.records() / "ball-d.png", "not a picture");
    const std::string page = build.page();
    CHECK(contains(page, "yours: the picture is missing"));
    CHECK(count(page, "<img ") == 2);
    CHECK(contains(page, "Task 6"));
}

TEST_CASE("results from before the last build are marked, and do not count", "[lab]") {
    Build build;
    build.add(recordOf(1, "one", Verdict::passed));
    build.add(recordOf(2, "two", Verdict::failed));
    CHECK_FALSE(contains(build.page(), "out of date"));
    build.buildAgain();
    const std::string page = build.page();
    CHECK(count(page, "passed 1 of 1 test (out of date)<") == 2);
    CHECK(count(page, "failed 1 of 1 test (out of date)<") == 2);
    CHECK(contains(page, "0 of 6 tasks pass."));
    CHECK(contains(page, "cmake --workflow --preset lab1"));
}

TEST_CASE("a test that is no more leaves no trace on the page", "[lab]") {
    Build build;
    build.add(recordOf(1, "of old", Verdict::failed));
    build.tests.clear();
    build.add(recordOf(1, "of now", Verdict::passed));
    const std::string page = build.page();
    CHECK_FALSE(contains(page, "of old"));
    CHECK(count(page, "passed 1 of 1 test<") == 2);
}
