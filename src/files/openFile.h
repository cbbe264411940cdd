#pragma once

#include <cstdio>
#include <filesystem>

namespace sw {

/// std::fopen() for a path with any characters: Windows has a function of its own for that.
/// @param mode  of letters that are ASCII
inline std::FILE* openFile(const std::filesystem::path& path, const char* mode) {
#ifdef _WIN32
    return _wfopen(path.c_str(), std::filesystem::path(mode).c_str());
#else
    return std::fopen(path.c_str(), mode);
#endif
}

}  // namespace sw
