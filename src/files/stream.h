#pragma once

#include <filesystem>
#include <string_view>

namespace sw {

/// Checks that an open stream takes output.
/// @param name  for the message
/// @throws FileError
void requireOpen(int stream, const std::filesystem::path& name);

/// Writes to an open stream, behind what it holds: a log that it is redirected to is kept.
/// @param name  for the message
/// @throws FileError
void writeToStream(int stream, std::string_view content, const std::filesystem::path& name);

}  // namespace sw
