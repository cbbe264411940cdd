#pragma once

#include <filesystem>
#include <string>

/// Other programs, run by the shell. On Windows none is ever installed: those that we use have no
/// command line there.
namespace report {

/// Whether a program answers to --version.
bool isInstalled(const std::string& program);

/// Text that the shell takes literally.
std::string quoted(const std::string& text);

/// Runs a command in a folder.
/// @return  what it printed, errors too
/// @throws std::runtime_error if it fails, with the end of what it printed
std::string outputOf(const std::string& command, const std::filesystem::path& folder);

}  // namespace report
