#pragma once

#include <filesystem>

namespace lab {

/// Writes the report, whole or not at all.
/// @param records  the folder of the records
/// @param program  that runs the lab's tests
/// @throws sw::FileError, std::filesystem::filesystem_error
void makePage(const std::filesystem::path& records, const std::filesystem::path& program,
              const std::filesystem::path& page);

}  // namespace lab
