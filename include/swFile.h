#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace sw {

/// A file that cannot be read or written. The message names the file, the reason and a way out.
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The content of a whole file.
/// @throws FileError
std::string readFile(const std::filesystem::path& path);

/// Writes a file whole or not at all: into a temporary file beside it, which is then renamed. A
/// failure, a full disk or a killed process leaves the old content. An existing file keeps its
/// mode. Written to directly: devices, pipes, open streams (/dev/stdout), files with several hard
/// links.
/// @throws FileError
void writeFile(const std::filesystem::path& path, std::string_view content);

/// Checks that writeFile may write there, as far as that is known. Call it before long work.
/// @param leastSize  bytes that the file will have at least
/// @throws FileError
void requireWritable(const std::filesystem::path& path, std::uintmax_t leastSize = 1);

}  // namespace sw
