#pragma once

#include <filesystem>

namespace sw {

/// A new empty file beside a target, .<target>.swtracer-<process>-<random number>.tmp, which no
/// other run uses. Removes itself at the end unless it was renamed.
class Temporary {
public:
    /// @param target  in a folder that exists
    /// @param named   the target's name in messages
    /// @throws FileError
    Temporary(const std::filesystem::path& target, const std::filesystem::path& named);
    ~Temporary();
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const std::filesystem::path path;
};

/// Removes temporary files beside a target whose process was killed: it no longer runs. On systems
/// that do not tell, those of yesterday and before.
void removeStale(const std::filesystem::path& target);

}  // namespace sw
