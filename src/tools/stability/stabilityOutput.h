#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/stability/results.h"

namespace report {

/// The table for readers, in Markdown.
std::string toTable(const std::vector<MethodResult>& results);

/// The CSV table: a line per method and family, and one per method for `all`.
std::string toCsv(const std::vector<MethodResult>& results);

/// Draws stability.svg and stability.png into a folder.
/// @return  one line: the files drawn, or why there are none
std::string plot(const std::vector<MethodResult>& results, const std::filesystem::path& folder);

}  // namespace report
