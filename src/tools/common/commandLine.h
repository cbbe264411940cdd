#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace report {

/// The options of a tool, or of one of its commands, and what it does. A header of its own over
/// CLI11, which takes 5 to 10 seconds in each file that includes it.
///
/// Options have names like "-o,--output"; a name without dashes takes a word of the command line.
class CommandLine {
public:
    explicit CommandLine(CLI::App& app) : app(app) {}

    /// A command with options of its own. The command line must name one.
    CommandLine addCommand(const char* name, const char* text);
    /// A command that may be left out. The options around it may come after it, too.
    CommandLine addChoice(const char* name, bool& chosen, const char* text);

    void addFlag(const char* name, bool& value, const char* text);
    void addRequired(const char* name, std::string& value, const char* text);
    void addSize(const char* name, std::optional<int>& value, const char* text);
    void addSize(const char* name, int& value, int least, int most, const char* text);
    void addFile(const char* name, std::filesystem::path& value, const char* text);
    void addFiles(const char* name, std::vector<std::filesystem::path>& value, const char* text);
    /// The value is what it is now, unless the command line says something else.
    void addFolder(const char* name, std::filesystem::path& value, const char* text);

    /// The end of --help.
    void setFooter(const std::string& text);
    /// What to do once the command line is read. May throw UsageError for an invalid one.
    void setWork(const std::function<void()>& work);

private:
    CLI::App& app;
};

/// Reads the command line, runs the tool, and reports errors on standard error.
/// @param setUp  adds the options and the work, which may throw UsageError, sw::NffError and
///               sw::FileError
/// @return       the exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output
int runTool(int argc, const char* const* argv, const char* name, const char* description,
            const std::function<void(CommandLine)>& setUp);

}  // namespace report
