#pragma once

#include <filesystem>
#include <functional>

namespace CLI {
class App;
}

/// Shared by the tools' main functions.
namespace report {

/// Reads the command line, runs the tool, and reports errors on standard error.
/// @param setUp  adds the options, and the work as a callback. It may throw CLI::ParseError for an
///               invalid command line, sw::NffError and sw::FileError
/// @return       the exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output
int runTool(int argc, const char* const* argv, const char* name, const char* description,
            const std::function<void(CLI::App&)>& setUp);

/// The path of a file in a folder. Creates the folder if it is missing.
/// @throws sw::FileError if the file cannot be written: call this before the work
std::filesystem::path outputFile(const std::filesystem::path& folder, const char* name);

/// The remark in the output of --quick.
constexpr const char* quickRemark = "--quick: a test run; the figures mean nothing";

}  // namespace report
