#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>

namespace sw {

/// 0, 1 or 2 for /dev/stdin, /dev/stdout and /dev/stderr, by name, on any system.
std::optional<int> standardStream(const std::filesystem::path& path);

/// Opens a file, or a standard stream where it stands, for reading bytes; null and errno if that
/// fails.
std::FILE* openToRead(const std::filesystem::path& path);

/// Whether an open file is a device other than a terminal, such as /dev/zero, which has no end.
bool isDevice(std::FILE* file);

}  // namespace sw
