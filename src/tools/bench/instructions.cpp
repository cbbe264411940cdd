#include "tools/bench/instructions.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "app/scenePath.h"
#include "swFile.h"
#include "tools/bench/callgrind.h"
#include "tools/common/command.h"
#include "tools/common/scenes/scenes.h"
#include "tools/common/table.h"

namespace bench {
namespace {

// {"lab picture": {"all": 680.1, "shading": 120.3, ...}, ...}: instructions per ray.
using Json = nlohmann::ordered_json;

const std::vector<ProgramPart> parts{
    {"shading", {"/src/main.cpp"}},
    {"filters", {"/accel/filter", "/accel/shapeRows", "/accel/trianglePacket"}},
    {"kernels", {"/swTriangle", "/swSphere", "/swCone", "/swPatch"}},
    {"search", {"/accel/", "/swScene", "/swBvh", "/swBounds", "/swRayCount"}},
    {"new rays", {"/swIntersection.cpp", "/swNumerics.cpp"}},
    {"camera", {"/swCamera", "/swSampling", "/sampling/"}}};

double perRay(std::uint64_t instructions, std::uint64_t rays) {
    return std::round(10 * static_cast<double>(instructions) / static_cast<double>(rays)) / 10;
}

// What the arguments of swtracer-counted say, counted.
Json count(const std::filesystem::path& folder, const std::string& arguments) {
    constexpr const char* profile = "callgrind.out";
    const std::string printed = report::outputOf(
        std::string("valgrind --quiet --tool=callgrind --callgrind-out-file=") + profile +
            " --toggle-collect='countedPicture*' " + report::quoted(SW_COUNTED) + " " + arguments,
        folder);
    std::ifstream file(folder / profile);
    const std::vector<std::uint64_t> counts = instructionsByPart(file, parts);
    file.close();
    std::filesystem::remove(folder / profile);

    const auto at = printed.find("rays ");
    if (at == std::string::npos) throw std::runtime_error("no number of rays:\n" + printed);
    const std::uint64_t rays = std::stoull(printed.substr(at + 5));
    Json line{
        {"all", perRay(std::accumulate(counts.begin(), counts.end(), std::uint64_t{}), rays)}};
    for (std::size_t i = 0; i < parts.size(); ++i) line[parts[i].name] = perRay(counts[i], rays);
    line["other"] = perRay(counts.back(), rays);
    return line;
}

Json countAll(const std::filesystem::path& folder) {
    Json lines;
    const std::string room =
        std::filesystem::absolute(findShippedScene("cornell.nff", "")).string();
    lines["lab picture"] = count(folder, report::quoted(room) + " 96 3 3");
    for (const scenes::Generator& generator : scenes::generators) {
        const std::string file = std::string(generator.name) + ".nff";
        sw::writeFile(folder / file, generator.generate(generator.usual));
        lines[generator.name] = count(folder, file + " 128 1 4");
        std::filesystem::remove(folder / file);
    }
    return lines;
}

std::string tableOf(const Json& lines) {
    std::vector<report::Row> rows{{"instructions per ray"}};
    for (const auto& [part, number] : lines.front().items()) rows[0].push_back(part);
    for (const auto& [scene, line] : lines.items()) {
        rows.push_back({scene});
        for (const auto& number : line) rows.back().push_back(report::fixed(number, 1));
    }
    return report::table(rows, 1);
}

// Only the same compiler makes the same program.
std::string compiler() {
#if defined(__clang__)
    return "clang++ " + std::to_string(__clang_major__);
#elif defined(__GNUC__)
    return "g++ " + std::to_string(__GNUC__);
#else
    return "unknown";
#endif
}

// Numbers that changed by more than 3 %, and by more than half an instruction: one per line.
std::string changes(const Json& before, const Json& now, double sign) {
    std::ostringstream list;
    for (const auto& [scene, line] : now.items()) {
        for (const auto& [part, number] : line.items()) {
            const double is = number, was = before.at(scene).at(part);
            if (sign * (is - was) > std::fmax(0.03 * was, 0.5))
                list << "\n  " << scene << ", " << part << ": " << was << " before, now " << is;
        }
    }
    return list.str();
}

void compare(const Json& accepted, const Json& now) {
    const std::string before = accepted.at("compiler");
    if (before != compiler()) {
        std::cout << "\nnot compared: instructions.json is for " << before << ", this is "
                  << compiler() << std::endl;
        return;
    }
    constexpr const char* wayOut = "\n`swtracer-bench instructions --accept` makes them the rule";
    const std::string more = changes(accepted.at("per ray"), now, 1);
    const std::string less = changes(accepted.at("per ray"), now, -1);
    if (!less.empty()) std::cout << "\nless than in instructions.json:" << less << wayOut << "\n";
    if (!more.empty()) throw std::runtime_error("more than 3 % more:" + more + wayOut);
    std::cout << "\nnothing takes 3 % more than in instructions.json" << std::endl;
}

void requireTools() {
    if (std::string(SW_COUNTED).empty())
        throw std::runtime_error("only g++ and clang++ for x86-64 make the program to be counted");
    if (!std::filesystem::exists(SW_COUNTED))
        throw std::runtime_error("expected the program " SW_COUNTED
                                 "; `cmake --build build --target instructions` builds it");
    if (!report::isInstalled("valgrind"))
        throw std::runtime_error(
            "valgrind is not installed; `sh external/setup.sh --developer` does so");
}

}  // namespace

void countInstructions(const std::filesystem::path& folder, bool accept) {
    requireTools();
    const Json now = countAll(folder);
    std::cout << tableOf(now) << std::flush;
    if (accept)
        sw::writeFile(SW_INSTRUCTIONS,
                      Json{{"compiler", compiler()}, {"per ray", now}}.dump(2) + "\n");
    else
        compare(Json::parse(std::ifstream(SW_INSTRUCTIONS)), now);
}

}  // namespace bench
