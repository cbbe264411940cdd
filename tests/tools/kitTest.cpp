#include <cstdlib>
#include <set>
#include <sstream>

#include "app/programRun.h"
#include "files.h"
#include "support.h"

using namespace test;

// What students get; whether it works is .ci/kit's business.

namespace {

const fs::path project = SW_PROJECT;

const fs::path& wholeKit() {
    static const TemporaryFolder folder;
    static const fs::path kit = folder / "kit";
    if (!fs::exists(kit)) {
        const Run run = runProgram("cmake", folder,
                                   "-D PROJECT=" + quoted(project) + " -D KIT=" + quoted(kit) +
                                       " -P " + quoted(project / "src/tools/kit/makeKit.cmake"));
        CAPTURE(run.err);
        REQUIRE(run.code == 0);
    }
    return kit;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
}

// The lines of a text that hold more than a brace, without white space.
std::multiset<std::string> linesOf(const std::string& text) {
    std::multiset<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        if (line.size() > 1) all.insert(line);
    }
    return all;
}

// Lines that a patch adds.
std::vector<std::string> added(const fs::path& patch) {
    std::vector<std::string> lines;
    std::istringstream in(contentOf(patch));
    for (std::string line; std::getline(in, line);)
        if (line[0] == '+' && line.compare(0, 3, "+++") != 0) lines.push_back(line.substr(1));
    return lines;
}

// Where students look: all of the kit but the sphere, which they get as an example.
std::multiset<std::string> shownLines() {
    std::multiset<std::string> shown;
    for (const fs::path& file : filesIn(wholeKit()))
        if (file.filename() != "swSphere.cpp") shown.merge(linesOf(contentOf(file)));
    return shown;
}

}  // namespace

TEST_CASE("the kit's sources are few") {
    std::size_t files = 0, lines = 0, atTop = 0;
    for (const char* folder : {"src", "include"})
        for (const fs::path& file : filesIn(wholeKit() / folder)) {
            const std::string text = contentOf(file);
            ++files;
            lines += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
            atTop += file.parent_path() == wholeKit() / "src";
        }
    CAPTURE(files, lines, atTop);
    CHECK(files <= 90);
    CHECK(lines <= 4000);
    CHECK(atTop <= 16);
}

TEST_CASE("main.cpp can be read at a glance") {
    for (const char* file : {"src/main.cpp", "src/tools/kit/starter/main.cpp"}) {
        const std::string text = contentOf(project / file);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 75);
    }
}

TEST_CASE("the kit contains no line of a solution") {
    const std::multiset<std::string> shown = shownLines();
    // Lines that the starter or other files contain for other reasons.
    const std::set<std::string> known{"hit.hitT=t;",
                                      "hit.normal.normalize();",
                                      "hit.material=material;",
                                      "hit.ray=ray;",
                                      "returntrue;",
                                      "Colorsum(0,0,0);",
                                      "Intersectionblocker;",
                                      "continue;",
                                      "returnfalse;",
                                      "namespace{",
                                      "}//namespace"};
    for (const char* folder : {"answers"})
        for (const fs::path& patch : filesIn(project / "tests/lab" / folder))
            for (const std::string& line : added(patch))
                for (const std::string& text : linesOf(line)) {
                    CAPTURE(patch, text);
                    CHECK((shown.count(text) == 0 || known.count(text) == 1));
                }
}

TEST_CASE("the kit does not include files that it lacks") {
    for (const fs::path& file : filesIn(wholeKit() / "src")) {
        const std::string text = contentOf(file);
        CAPTURE(file);
        for (const char* room :
             {"\"accel/", "\"adaptive/", "\"files/", "\"nff/polygon/", "swCone.h", "swPatch.h"})
            CHECK(text.find(room) == std::string::npos);
    }
}

TEST_CASE("every mistake names its task and the expected hint") {
    int mistakes = 0;
    for (const fs::path& patch : filesIn(project / "tests/lab/mistakes")) {
        const std::string text = contentOf(patch);
        CAPTURE(patch);
        CHECK(text.compare(0, 6, "Task: ") == 0);
        CHECK((text[6] >= '1' && text[6] <= '6'));
        CHECK((text.find("\nSays: ") == 7 || text.find("\nSays nothing\n\n") == 7));
        CHECK(text.find("\n@@ ") != std::string::npos);
        ++mistakes;
    }
    CHECK(mistakes >= 90);
}

TEST_CASE("every right program says in which words it is right") {
    int programs = 0;
    for (const fs::path& patch : filesIn(project / "tests/lab/right")) {
        const std::string text = contentOf(patch);
        CAPTURE(patch);
        CHECK((text.compare(0, 7, "Right: ") == 0 || text.compare(0, 7, "Loses: ") == 0));
        CHECK(text.find("\n@@ ") != std::string::npos);
        ++programs;
    }
    CHECK(programs >= 12);
}
