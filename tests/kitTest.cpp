#include "kit.h"

#include <set>
#include <sstream>

#include "edit.h"
#include "files.h"
#include "support.h"

using namespace test;

namespace {

const fs::path project = SW_PROJECT;
const char* const studentFiles[] = {"src/main.cpp", "src/swTriangle.cpp", "src/swIntersection.cpp"};

// A new kit of the whole project.
const fs::path& wholeKit() {
    static const TemporaryFolder folder;
    static const bool made = (kit::makeKit(project, folder / "kit"), true);
    static const fs::path path = folder / "kit";
    REQUIRE(made);
    return path;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
}

// The lines of a text without white space.
std::multiset<std::string> linesOf(const std::string& text) {
    std::multiset<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        lines.insert(line);
    }
    return lines;
}

// Every line of the kit but those of the sphere, which students get as an example.
std::multiset<std::string> shownLines() {
    std::multiset<std::string> shown;
    for (const fs::path& file : filesIn(wholeKit()))
        if (file.filename() != "swSphere.cpp") shown.merge(linesOf(contentOf(file)));
    return shown;
}

std::string cutError(const std::string& text) {
    try {
        kit::cut(text, "a.cpp");
        return "";
    } catch (const kit::KitError& error) {
        return error.what();
    }
}

std::string starter(const std::string& text) {
    return kit::starterOf(kit::cut(text, "a.cpp"));
}

}  // namespace

TEST_CASE("a region's starter takes the place of its solution") {
    const std::string text =
        "int f() {\n"
        "    // task 1 >>>\n"
        "    //| // TODO\n"
        "    //|\n"
        "    //|     return 0;\n"
        "    return 42;  // >>> no mark\n"
        "    // <<<\n"
        "}\n";
    CHECK(starter(text) == "int f() {\n    // TODO\n\n        return 0;\n}\n");
    const auto source = kit::cut(text, "a.cpp");
    CHECK(kit::solutionOf(source, "task 1", "a.cpp") == "    return 42;  // >>> no mark\n");
    CHECK_THROWS_AS(kit::solutionOf(source, "task 2", "a.cpp"), kit::KitError);
}

TEST_CASE("a region may lack a starter or a solution, and CMake has marks of its own") {
    CHECK(starter("a\n# kit >>>\nb\n# <<<\nc\n") == "a\nc\n");
    CHECK(starter("a\n# kit >>>\n#| b\n# <<<\nc") == "a\nb\nc");
    CHECK(starter("a\n\n// kit >>>\nb\n// <<<\n\n\nc\n") == "a\n\nc\n");
    CHECK(starter("") == "");
    CHECK(starter("a") == "a");
}

TEST_CASE("marks that do not fit together are an error that names the line") {
    CHECK(startsWith(cutError("a\n// task 1 >>>\nb\n"), "a.cpp:2: expected `<<<`"));
    CHECK(startsWith(cutError("a\n// <<<\n"), "a.cpp:2: expected a region to end"));
    CHECK(startsWith(cutError("// a >>>\n\n// b >>>\n// <<<\n"),
                     "a.cpp:3: expected `<<<` to end the region of line 1"));
}

TEST_CASE("the kit shows no line of the solution") {
    const auto shown = shownLines();
    int looked = 0;
    for (const char* file : studentFiles) {
        const auto source = kit::cut(contentOf(project / file), file);
        for (const kit::Region& region : source.regions)
            for (const std::string& line : linesOf(region.solution)) {
                // "return true;" and the like give nothing away, nor what the starter has.
                if (line.size() < 24 || startsWith(line, "#include")) continue;
                if (linesOf(region.starter).count(line) > 0) continue;
                CAPTURE(file, region.name, line);
                CHECK(shown.count(line) == 0);
                ++looked;
            }
    }
    CHECK(looked > 60);
}

TEST_CASE("the kit shows no line of the sample answers") {
    const auto shown = shownLines();
    int looked = 0;
    for (const fs::path& file : filesIn(project / "tests/lab/student"))
        for (const auto& change : kit::parseEdit(contentOf(file), file.string()).replacements)
            for (const std::string& line : linesOf(change.after)) {
                if (line.size() < 24) continue;
                CAPTURE(file, line);
                CHECK(shown.count(line) == 0);
                ++looked;
            }
    CHECK(looked > 20);
}

TEST_CASE("the kit has no marks, and a task to do in every file that students write") {
    for (const fs::path& file : filesIn(wholeKit())) {
        const std::string content = contentOf(file);
        CAPTURE(file);
        CHECK(content.find(" >>>\n") == std::string::npos);
        CHECK(content.find("//|") == std::string::npos);
    }
    for (const char* file : studentFiles)
        CHECK(contentOf(wholeKit() / file).find("TODO") != std::string::npos);
}

TEST_CASE("every task has a placeholder, which the handout shows") {
    std::string code;
    for (const char* file : studentFiles) code += contentOf(wholeKit() / file);
    const std::string handout = contentOf(wholeKit() / "README.md");
    for (const std::string name : {"diffuse", "intersect", "isInShadow", "reflection",
                                   "reflectedRay", "refraction", "refractedRay", "samplePixel"}) {
        CAPTURE(name);
        CHECK(code.find("todo::" + name + "(") != std::string::npos);
        CHECK(handout.find("todo::" + name + "(") != std::string::npos);
    }
}

TEST_CASE("a kit is not written over something else") {
    const TemporaryFolder folder;
    makeFile(folder / "mine.txt", "mine");
    CHECK_THROWS_AS(kit::makeKit(project, folder.path), kit::KitError);
    CHECK(folder.count() == 1);
}

TEST_CASE("the kit's list names files and patterns, and what to leave out") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a");
    for (const char* name : {"a/x.h", "a/y.h", "a/z.cpp", "b.txt"}) makeFile(folder / name, "");
    const auto files = [&](const std::string& list) { return kit::filesOf(list, folder.path); };
    CHECK(files("# all\na/*.h  # headers\n\nb.txt\n") ==
          std::vector<fs::path>{"a/x.h", "a/y.h", "b.txt"});
    CHECK(files("a/*.h\na/*.cpp\n- a/x.h\n") == std::vector<fs::path>{"a/y.h", "a/z.cpp"});
    for (const char* nothing : {"c.txt", "a/*.txt", "c/*.h", "a/*.h\n- a/z.cpp"}) {
        CAPTURE(nothing);
        CHECK_THROWS_AS(files(nothing), kit::KitError);
    }
}

TEST_CASE("a template takes in a region's solution") {
    const TemporaryFolder folder;
    makeFile(folder / "a.cpp", "// task 1 >>>\n//| no\nyes\n// <<<\n");
    CHECK(kit::filled("before\n//= a.cpp: task 1\nafter\n", "t", folder.path) ==
          "before\nyes\nafter\n");
    CHECK_THROWS_AS(kit::filled("//= a.cpp: task 2\n", "t", folder.path), kit::KitError);
    CHECK_THROWS_AS(kit::filled("//= a.cpp\n", "t", folder.path), kit::KitError);
}

TEST_CASE("an edit replaces what stands just once, or nothing at all") {
    const TemporaryFolder folder;
    makeFile(folder / "a", "one\ntwo\ntwo\n");
    makeFile(folder / "b", "one\n");
    const auto edit = [&](const std::string& text) {
        kit::apply(kit::parseEdit(text, "e"), folder.path);
    };
    edit(
        "task: 3\nsays: so\nfile: a\n<<<<\none\n====\n1\n1\n>>>>\nfile: "
        "b\n<<<<\none\n====\n>>>>\n");
    CHECK(contentOf(folder / "a") == "1\n1\ntwo\ntwo\n");
    CHECK(contentOf(folder / "b").empty());
    CHECK_THROWS_AS(edit("file: a\n<<<<\n1\n1\n====\n>>>>\n<<<<\ntwo\n====\n>>>>\n"),
                    kit::KitError);
    CHECK_THROWS_AS(edit("file: a\n<<<<\nthree\n====\n>>>>\n"), kit::KitError);
    CHECK(contentOf(folder / "a") == "1\n1\ntwo\ntwo\n");
    for (const char* broken : {"", "file: a\n<<<<\nx\n", "<<<<\nx\n====\n>>>>\n", "file: a\nwhat\n",
                               "file: a\ncolour: red\n<<<<\nx\n====\n>>>>\n"})
        CHECK_THROWS_AS(kit::parseEdit(broken, "e"), kit::KitError);
}

TEST_CASE("every mistake of the mutation suite is an edit with a task and a hint") {
    int mistakes = 0;
    for (const fs::path& file : filesIn(project / "tests/lab/mutants")) {
        const kit::Edit edit = kit::parseEdit(contentOf(file), file.string());
        CAPTURE(file);
        CHECK((edit.task >= 1 && edit.task <= 6));
        CHECK(edit.says.size() > 8);
        ++mistakes;
    }
    CHECK(mistakes >= 18);
}
