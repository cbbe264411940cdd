#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "swFile.h"
#include "tools/generators/scenes.h"

namespace {

using scenes::Generator;

struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Options {
    std::string name;
    int size = 0;
    std::filesystem::path output;
};

// What --help says at its end.
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

void run(const Options& options, bool sizeGiven) {
    const Generator& scene = generatorOf(options.name);
    if (sizeGiven) requireSize(scene, options.size);
    const std::string text = scene.generate(sizeGiven ? options.size : scene.usual);
    if (!options.output.empty()) return sw::writeFile(options.output, text);
    std::cout << text << std::flush;
    if (!std::cout) throw sw::FileError("standard output: cannot write; is the disk full?");
}

}  // namespace

// Exit codes: 0 done, 1 unexpected, 2 command line, 4 output.
int main(int argc, char** argv) {
    const auto fail = [](int code, const std::exception& error) {
        std::cerr << "swtracer-scene: " << error.what() << std::endl;
        return code;
    };
    try {
        Options options;
        CLI::App app("Writes a scene that grows with its size, in NFF.", "swtracer-scene");
        app.footer(listOfScenes());
        app.add_option("name", options.name, "of the scene")->required();
        app.add_option("--size", options.size, "how far it has grown");
        app.add_option("-o,--output", options.output, "file to write; default: standard output");
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() == 0) return app.exit(error);  // --help
            return fail(2, error);
        }
        run(options, app.count("--size") > 0);
        return 0;
    } catch (const UsageError& error) {
        return fail(2, error);
    } catch (const sw::FileError& error) {
        return fail(4, error);
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}
