#pragma once

#include <filesystem>
#include <string>

namespace sw {

/// @throws FileError "path: cannot write: why"
[[noreturn]] void failToWrite(const std::filesystem::path& path, const std::string& why);

/// What an errno means; 0 is an error of unknown kind.
std::string reasonOf(int error);

}  // namespace sw
