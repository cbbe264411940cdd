#include "tools/common/commandLine.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "app/usage.h"
#include "swFile.h"
#include "swNff.h"

namespace report {

CommandLine CommandLine::addCommand(const char* name, const char* text) {
    app.require_subcommand(1);
    return CommandLine(*app.add_subcommand(name, text));
}

CommandLine CommandLine::addChoice(const char* name, bool& chosen, const char* text) {
    CLI::App& choice = *app.add_subcommand(name, text)->fallthrough();
    choice.callback([&chosen] { chosen = true; });  // before the work
    return CommandLine(choice);
}

void CommandLine::addFlag(const char* name, bool& value, const char* text) {
    app.add_flag(name, value, text);
}

void CommandLine::addRequired(const char* name, std::string& value, const char* text) {
    app.add_option(name, value, text)->required();
}

void CommandLine::addSize(const char* name, std::optional<int>& value, const char* text) {
    app.add_option(name, value, text);
}

void CommandLine::addSize(const char* name, int& value, int least, int most, const char* text) {
    app.add_option(name, value, text)->check(CLI::Range(least, most))->capture_default_str();
}

void CommandLine::addFile(const char* name, std::filesystem::path& value, const char* text) {
    app.add_option(name, value, text);
}

void CommandLine::addFiles(const char* name, std::vector<std::filesystem::path>& value,
                           const char* text) {
    app.add_option(name, value, text);
}

void CommandLine::addFolder(const char* name, std::filesystem::path& value, const char* text) {
    app.add_option(name, value, text)->capture_default_str();
}

void CommandLine::setFooter(const std::string& text) {
    app.footer(text);
}

void CommandLine::setWork(const std::function<void()>& work) {
    app.callback(work);
}

int runTool(int argc, const char* const* argv, const char* name, const char* description,
            const std::function<void(CommandLine)>& setUp) {
    const auto fail = [&](int code, const std::exception& error) {
        std::cerr << name << ": " << error.what() << std::endl;
        return code;
    };
    try {
        CLI::App app(description, name);
        setUp(CommandLine(app));
        try {
            app.parse(argc, argv);  // does the work
        } catch (const CLI::ParseError& error) {
            if (error.get_exit_code() == 0) return app.exit(error);  // --help
            return fail(2, error);
        }
        return 0;
    } catch (const UsageError& error) {
        return fail(2, error);
    } catch (const sw::NffError& error) {
        return fail(3, error);
    } catch (const sw::FileError& error) {
        return fail(4, error);
    } catch (const std::exception& error) {
        return fail(1, error);
    }
}

}  // namespace report
