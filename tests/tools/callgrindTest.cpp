#include "tools/bench/callgrind.h"

#include <sstream>

#include "catch.h"

using Counts = std::vector<std::uint64_t>;

namespace {

const std::vector<bench::ProgramPart> parts{
    {"filter", {"/accel/filter"}}, {"search", {"/accel/"}}, {"kernel", {"/triangle.", "/sphere."}}};

Counts countsIn(const std::string& profile) {
    std::istringstream text(profile);
    return bench::instructionsByPart(text, parts);
}

}  // namespace

TEST_CASE("a line's instructions belong to the first part that its file is in") {
    CHECK(countsIn("summary: 15\nfl=(1) /src/accel/filterRay.h\nfn=(1) f\n+7 1\n"
                   "fl=(2) /src/accel/search.h\nfn=(2) g\n-3 2\n"
                   "fl=(3) /src/sphere.cpp\nfn=(3) h\n* 4\n"
                   "fl=(4) /src/main.cpp\nfn=(4) main\n12 8\n") == Counts{1, 2, 4, 8});
}

TEST_CASE("an inlined function belongs to its own file, its caller goes on as before") {
    CHECK(countsIn("summary: 111\nfl=(1) /accel/search.h\nfn=(1) f\n1 1\nfi=(2) /triangle.h\n9 10\n"
                   "fe=(1)\n+1 100\n") == Counts{0, 101, 10, 0});
}

TEST_CASE("what belongs to no part goes along with the lines before it in the function") {
    CHECK(countsIn("summary: 1111\nfl=(1) /accel/search.h\nfn=(1) f\n1 1\nfi=(2) /vector\n9 10\n"
                   "fi=(3) /accel/filter.h\n2 100\nfi=(2)\n9 1000\n") == Counts{1100, 11, 0, 0});
}

TEST_CASE("what a function begins with goes along with what follows, if it belongs to no part") {
    CHECK(countsIn("summary: 1111\nfl=(1) /vector\nfn=(1) f\n1 1\nfi=(2) /sphere.h\n+1 10\n"
                   "fl=(1)\nfn=(2) g\n1 100\nfl=(2)\nfn=(3) h\n5 1000\n") ==
          Counts{0, 0, 1011, 100});
}

TEST_CASE("a call's instructions count once, in the function called") {
    CHECK(countsIn("summary: 11\nfl=(1) /accel/search.h\nfn=(1) f\n1 1\ncfi=(2) /triangle.cpp\n"
                   "cfn=(2) g\ncalls=5 70\n+1 10\n\nfl=(2)\nfn=(2)\n70 10\n") ==
          Counts{0, 1, 10, 0});
    CHECK(countsIn("summary: 7\nfl=(1) /accel/search.h\nfn=(1) f\n1 1\nfn=(2) g\n2 6\n") ==
          Counts{0, 7, 0, 0});
}

TEST_CASE("a profile of which lines are missing is refused") {
    CHECK_THROWS_WITH(countsIn("summary: 12\nfl=(1) /triangle.cpp\nfn=(1) f\n1 11\n"),
                      "callgrind's output: the lines add up to 11 instructions, the summary says "
                      "12");
    CHECK_THROWS(countsIn("summary: 12\n"));
}
