#pragma once

#include <filesystem>
#include <functional>

namespace CLI {
class App;
}

/// What the tools' main functions have in common.
namespace report {

/// Reads the command line and does what it asks for; says on standard error what went wrong.
/// @param setUp  adds the options, and as callback the work. It may throw CLI::ParseError for a
///               mistake in the command line, sw::NffError and sw::FileError
/// @return       the exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output
int runTool(int argc, const char* const* argv, const char* name, const char* description,
            const std::function<void(CLI::App&)>& setUp);

/// The path of a file in a folder, which is made where it is missing.
/// @throws sw::FileError where the file cannot be written: better before the work than after it
std::filesystem::path outputFile(const std::filesystem::path& folder, const char* name);

/// What the output says where --quick was asked for.
constexpr const char* quickRemark = "--quick: only shows that it runs; the figures mean nothing";

}  // namespace report
