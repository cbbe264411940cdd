#include <CLI/CLI.hpp>
#include <iostream>

#include "edit.h"
#include "kit.h"
#include "swFile.h"

namespace {

namespace fs = std::filesystem;

// What the command line asks for.
struct Command {
    fs::path project, kit, text, output;
    std::vector<fs::path> edits;
};

void addCommands(CLI::App& app, Command& given) {
    app.require_subcommand(1);
    CLI::App* const make = app.add_subcommand("make", "Writes the students' kit.");
    make->add_option("project", given.project, "this project's folder")->required();
    make->add_option("kit", given.kit, "folder to write, new or empty")->required();

    CLI::App* const fill =
        app.add_subcommand("fill", "Replaces lines '//= file: region' by the region's solution.");
    fill->add_option("project", given.project, "this project's folder")->required();
    fill->add_option("template", given.text, "text with such lines")->required();
    fill->add_option("output", given.output, "file to write")->required();

    CLI::App* const edit = app.add_subcommand("edit", "Changes a kit as a student would.");
    edit->add_option("kit", given.kit, "the kit's folder")->required();
    edit->add_option("edits", given.edits, "files that say what to change")->required();
}

void run(const CLI::App& app, const Command& given) {
    if (app.got_subcommand("make")) kit::makeKit(given.project, given.kit);
    if (app.got_subcommand("fill"))
        sw::writeFile(given.output,
                      kit::filled(sw::readFile(given.text), given.text.string(), given.project));
    for (const fs::path& edit : given.edits)
        kit::apply(kit::parseEdit(sw::readFile(edit), edit.string()), given.kit);
}

}  // namespace

// Exit codes: 0 done, 1 failed, 2 command line.
int main(int argc, char** argv) {
    CLI::App app("Makes the students' kit out of this project.", "swtracer-kit");
    Command given;
    addCommands(app, given);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help
        std::cerr << "swtracer-kit: " << error.what() << std::endl;
        return 2;
    }
    try {
        run(app, given);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "swtracer-kit: " << error.what() << std::endl;
        return 1;
    }
}
