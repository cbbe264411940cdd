#pragma once

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
/// failure, a full disk or a killed process leaves the old content. If the path is not a regular
/// file (but a terminal or a pipe), it is written to directly.
/// @throws FileError
void writeFile(const std::filesystem::path& path, std::string_view content);

/// Checks that the folder exists and writeFile may write there. Call it before long work.
/// @throws FileError
void requireWritable(const std::filesystem::path& path);

}  // namespace sw
