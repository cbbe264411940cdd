#pragma once

#include <filesystem>

/// Shared by the tools' main functions.
namespace report {

/// The path of a file in a folder. Creates the folder if it is missing.
/// @throws sw::FileError if the file cannot be written: call this before the work
std::filesystem::path outputFile(const std::filesystem::path& folder, const char* name);

/// The remark in the output of --quick.
constexpr const char* quickRemark = "--quick: a test run; the figures mean nothing";

}  // namespace report
