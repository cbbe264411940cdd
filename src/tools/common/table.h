#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace report {

using Row = std::vector<std::string>;

/// A number with that many digits, in scientific notation if it gets long; a dash for NaN.
std::string rounded(double value, int digits);

/// A number with that many decimals; a dash for NaN.
std::string fixed(double value, int decimals);

/// A table in Markdown, with columns of even width.
/// @param rows         at least the heading; all of the same length
/// @param wordColumns  that many columns from the left hold words, the others numbers
std::string table(const std::vector<Row>& rows, std::size_t wordColumns);

/// The same as an HTML table.
std::string htmlTable(const std::vector<Row>& rows, std::size_t wordColumns);

/// The same as CSV, for programs. No cell may contain a comma.
std::string csv(const std::vector<Row>& rows);

}  // namespace report
