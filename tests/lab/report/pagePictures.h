#pragma once

#include <filesystem>
#include <string>

#include "lab/record.h"

namespace lab {

/// A test's pictures as pieces of the page: expected, the student's and the difference side by
/// side, with a ring around the pixel that is farthest off. Empty if the test has none.
/// @param records  the folder of the picture files; says so on the page where one is missing
std::string picturesOf(const Record& record, const std::filesystem::path& records);

}  // namespace lab
