#pragma once

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace report {

using Row = std::vector<std::string>;

/// A table in Markdown, with columns of even width.
/// @param rows         at least the heading; all of the same length
/// @param wordColumns  so many columns from the left hold words, the others numbers
std::string table(const std::vector<Row>& rows, std::size_t wordColumns);

/// The same as a table of a web page.
std::string htmlTable(const std::vector<Row>& rows, std::size_t wordColumns);

}  // namespace report
