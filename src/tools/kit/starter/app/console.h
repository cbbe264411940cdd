#pragma once

#include <iostream>
#include <string>
#include <vector>

#include "swFile.h"

/// Prints each warning on a line of stderr.
inline void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "swtracer: " << warning << std::endl;
}

/// Prints on stdout. A result that did not arrive is a failure.
inline void print(const std::string& text) {
    std::cout << text << std::flush;
    if (!std::cout) throw sw::FileError("standard output: cannot write; is the disk full?");
}
