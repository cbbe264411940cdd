#include <filesystem>
#include <iostream>
#include <optional>

#include "app/usage.h"
#include "swFile.h"
#include "tools/common/commandLine.h"
#include "tools/common/scenes/scenes.h"

namespace {

using scenes::Generator;

struct Options {
    std::string name;
    std::optional<int> size;
    std::filesystem::path output;
};

// The end of --help.
std::string listOfScenes() {
    std::string list = "Scenes, with their sizes:";
    for (const Generator& g : scenes::generators)
        list += std::string("\n  ") + g.name + "  " + std::to_string(g.least) + " to " +
                std::to_string(g.most) + ", default " + std::to_string(g.usual) + "  " + g.shows;
    return list;
}

const Generator& generatorOf(const std::string& name) {
    std::string names;
    for (const Generator& g : scenes::generators) {
        if (name == g.name) return g;
        names += (names.empty() ? "" : ", ") + std::string(g.name);
    }
    throw UsageError("expected the name of a scene (" + names + "), found '" + name + "'");
}

void requireSize(const Generator& g, int size) {
    if (size < g.least || size > g.most)
        throw UsageError("--size: expected " + std::to_string(g.least) + " to " +
                         std::to_string(g.most) + " for " + g.name + ", found " +
                         std::to_string(size));
}

void run(const Options& options) {
    const Generator& scene = generatorOf(options.name);
    const int size = options.size.value_or(scene.usual);
    requireSize(scene, size);
    const std::string text = scene.generate(size);
    if (!options.output.empty()) return sw::writeFile(options.output, text);
    std::cout << text << std::flush;
    if (!std::cout) throw sw::FileError("standard output: cannot write; is the disk full?");
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    return report::runTool(
        argc, argv, "swtracer-scene", "Writes a scene that grows with its size, in NFF.",
        [&](report::CommandLine line) {
            line.setFooter(listOfScenes());
            line.addRequired("name", options.name, "name of the scene");
            line.addSize("--size", options.size, "size of the scene");
            line.addFile("-o,--output", options.output, "file to write; default: standard output");
            line.setWork([&] { run(options); });
        });
}
