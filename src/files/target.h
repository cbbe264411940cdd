#pragma once

#include <filesystem>
#include <optional>

namespace sw {

/// Where bytes that are written to a path really go.
struct Target {
    std::filesystem::path file;  ///< symbolic links followed, in a canonical folder
    std::optional<int> stream;   ///< set for an open stream of this process, as /dev/stdout is

    /// Whether the file is neither a regular one nor a folder, but a device or a pipe.
    bool isSpecial() const;
};

/// Follows symbolic links, also to a file that does not exist yet.
/// @throws FileError if the path names no file
Target targetOf(const std::filesystem::path& path);

}  // namespace sw
