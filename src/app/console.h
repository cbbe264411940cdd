#pragma once

#include <string>
#include <vector>

/// A text with its control characters as \x0a, so that a file's name cannot break a message.
std::string oneLine(const std::string& text);

/// Prints on stdout. A result that did not arrive is a failure.
/// @throws sw::FileError
void print(const std::string& text);

/// Prints each warning on a line of stderr.
void printWarnings(const std::vector<std::string>& warnings);
