#pragma once

#include <filesystem>
#include <string>

namespace sw {

/// A path whose name was given in UTF-8, as all names are that the program gets: on Windows as well
/// (external/windows).
inline std::filesystem::path pathOfUtf8(const std::string& name) {
    return std::u8string(name.begin(), name.end());
}

/// The same for a path that was made of such a name by std::filesystem::path(std::string). With
/// mingw-w64, that takes each byte for a character of its own.
inline std::filesystem::path readAsUtf8(const std::filesystem::path& path) {
#ifdef __MINGW32__
    std::string name;
    for (const wchar_t c : path.native()) name += static_cast<char>(c);
    if (std::filesystem::path(name).native() != path.native()) return path;
    try {
        return pathOfUtf8(name);
    } catch (const std::filesystem::filesystem_error&) {  // not UTF-8: it is what it is
    }
#endif
    return path;
}

}  // namespace sw
