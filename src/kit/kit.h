#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "regions.h"

/// The students' kit: the project's own files with the starter in place of the solution, and a few
/// that only the kit has.
namespace kit {

/// The files of the kit, relative to the project's folder, sorted.
/// @param list  one per line: `folder/name`, `folder/*.ending`, or `- folder/name` to leave out
/// what
///              an earlier line has named; `#` begins a comment
/// @throws KitError for a line that names nothing
std::vector<std::filesystem::path> filesOf(const std::string& list,
                                           const std::filesystem::path& project);

/// Writes the kit, from the list in src/kit/files.txt and all files in src/kit/files.
/// @param kit  a folder that does not exist, or is empty
/// @throws KitError, sw::FileError
void makeKit(const std::filesystem::path& project, const std::filesystem::path& kit);

/// Fills a template: a line `//= file: region` becomes the region's solution.
/// @throws KitError, sw::FileError
std::string filled(const std::string& text, const std::string& name,
                   const std::filesystem::path& project);

}  // namespace kit
