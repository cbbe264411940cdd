#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace report {

using Row = std::vector<std::string>;

/// A number of so many digits, in powers of ten where it gets long; a dash for NaN.
std::string rounded(double value, int digits);

/// A number of so many decimals; a dash for NaN.
std::string fixed(double value, int decimals);

/// A table in Markdown, with columns of even width.
/// @param rows         at least the heading; all of the same length
/// @param wordColumns  so many columns from the left hold words, the others numbers
std::string table(const std::vector<Row>& rows, std::size_t wordColumns);

/// The same as a table of a web page.
std::string htmlTable(const std::vector<Row>& rows, std::size_t wordColumns);

/// The same for programs: values between commas. No cell may hold a comma.
std::string csv(const std::vector<Row>& rows);

}  // namespace report
