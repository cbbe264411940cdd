// The house has one direction of dependency (DESIGN: "The rooms"):
//
//     values -> shapes -> scene (accel) -> picture (sampling, adaptive) -> files (nff) -> rayTree
//            -> app -> main, tools
//
// Read from the #include lines of all sources.

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "files.h"
#include "support.h"

using namespace test;

namespace {

using Names = std::set<std::string>;

const Names values{"swVec3",
                   "swRay",
                   "swLight",
                   "swMaterial",
                   "swBounds",
                   "swNumerics",
                   "swFile",
                   "swIntersection",
                   "swRayCount",
                   "swSampling",
                   "sampling/splitMix64",
                   "swStop",
                   "swThreads",
                   "swZeroMemory"};
const Names shapes{"swPrimitive", "swSphere", "swTriangle", "swCone", "swPatch"};
const Names scene{"swBvh", "swBvhNode", "swScene"};

bool startsWith(const std::string& text, const std::string& start) {
    return text.compare(0, start.size(), start) == 0;
}

// The place of a unit in the order above.
int layerOf(const std::string& unit) {
    if (values.count(unit) > 0 || startsWith(unit, "files/")) return 0;
    if (shapes.count(unit) > 0) return 1;
    if (scene.count(unit) > 0 || startsWith(unit, "accel/")) return 2;
    if (startsWith(unit, "nff/") || unit == "swNff") return 4;
    if (startsWith(unit, "rayTree/")) return 5;
    if (startsWith(unit, "app/")) return 6;
    if (startsWith(unit, "tools/") || unit == "main") return 7;
    return 3;
}

// What a header and its source have in common: include/swBvh.h and src/accel/swBvh.cpp are swBvh.
std::string unitOf(const fs::path& file) {
    const std::string stem = file.stem().string();
    if (startsWith(stem, "sw")) return stem;
    return (file.lexically_relative(fs::path(SW_PROJECT) / "src").parent_path() / stem)
        .generic_string();
}

std::string unitOfInclude(const std::string& name) {
    return name.substr(0, name.rfind('.'));
}

struct Include {
    std::string from, to;
};

std::vector<Include> includesOf(const fs::path& file) {
    static const std::regex line("#include \"([^\"]+)\"");
    const std::string text = contentOf(file);
    std::vector<Include> result;
    for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i)
        result.push_back({unitOf(file), unitOfInclude((*i)[1])});
    return result;
}

const std::vector<Include>& allIncludes() {
    static const std::vector<Include> all = [] {
        std::vector<Include> result;
        for (const char* folder : {"include", "src"})
            for (const auto& entry :
                 fs::recursive_directory_iterator(fs::path(SW_PROJECT) / folder)) {
                const std::string place = entry.path().generic_string();
                if (place.find("/tools/kit/") != std::string::npos) continue;  // other swScene
                const fs::path ending = entry.path().extension();
                if (ending != ".h" && ending != ".cpp") continue;
                const auto some = includesOf(entry.path());
                result.insert(result.end(), some.begin(), some.end());
            }
        return result;
    }();
    return all;
}

// The tool that a unit belongs to; "" outside of tools.
std::string toolOf(const std::string& unit) {
    if (!startsWith(unit, "tools/")) return "";
    const std::size_t slash = unit.find('/', 6);
    return slash == std::string::npos ? "" : unit.substr(6, slash - 6);
}

}  // namespace

TEST_CASE("no source includes one of a later layer") {
    CHECK(allIncludes().size() > 300);
    for (const Include& include : allIncludes()) {
        CAPTURE(include.from, include.to);
        CHECK(layerOf(include.to) <= layerOf(include.from));
    }
}

TEST_CASE("there are no circular includes") {
    std::map<std::string, Names> below;
    for (const Include& include : allIncludes())
        if (include.from != include.to) below[include.from].insert(include.to);
    // Repeatedly removes units that include none of the others or that no other includes. Those
    // that remain are part of a circle, or between two circles.
    for (bool changed = true; changed;) {
        Names used;
        for (auto& [unit, others] : below) {
            std::erase_if(others, [&](const auto& to) { return below.count(to) == 0; });
            used.insert(others.begin(), others.end());
        }
        changed = std::erase_if(below, [&](const auto& entry) {
                      return entry.second.empty() || used.count(entry.first) == 0;
                  }) > 0;
    }
    for (const auto& [unit, others] : below) {
        std::string circle;
        for (const std::string& other : others) circle += " " + other;
        CAPTURE(unit, circle);
        CHECK(others.empty());
    }
}

TEST_CASE("pictures and trees do not depend on scenes") {
    for (const Include& include : allIncludes()) {
        CAPTURE(include.from, include.to);
        if (layerOf(include.from) == 3) CHECK(layerOf(include.to) != 2);
        if (include.from == "swBvh") CHECK(include.to != "swScene");
    }
}

TEST_CASE("no file of a tool is used by another tool, unless it is common") {
    for (const Include& include : allIncludes()) {
        const std::string from = toolOf(include.from), to = toolOf(include.to);
        CAPTURE(include.from, include.to);
        if (from != "" && to != "" && to != "common") CHECK(from == to);
    }
}

TEST_CASE("only the program and the tools know the command line") {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SW_PROJECT) / "src")) {
        if (!entry.is_regular_file() || entry.path().extension() == ".png") continue;
        const std::string unit = unitOf(entry.path());
        const std::string text = contentOf(entry.path());
        CAPTURE(unit);
        if (layerOf(unit) < 6) CHECK(text.find("CLI/CLI.hpp") == std::string::npos);
        if (layerOf(unit) < 6) CHECK(text.find("nlohmann") == std::string::npos);
    }
}

// It takes 5 to 10 seconds in each file that includes it.
TEST_CASE("one file of the tools alone includes CLI11") {
    std::string found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SW_PROJECT) / "src/tools")) {
        const std::string place = entry.path().generic_string();
        if (!entry.is_regular_file() || place.find("/tools/kit/") != std::string::npos) continue;
        if (contentOf(entry.path()).find("#include <CLI") != std::string::npos)
            found += entry.path().filename().string() + " ";
    }
    CHECK(found == "commandLine.cpp ");
}

TEST_CASE("the top folder of src holds few files") {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(SW_PROJECT) / "src"))
        files += entry.is_regular_file() && entry.path().filename() != "CMakeLists.txt";
    CHECK(files <= 16);
}
