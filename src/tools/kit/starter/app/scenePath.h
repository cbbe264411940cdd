#pragma once

#include <filesystem>

/// The path of a scene that comes with the kit.
inline std::filesystem::path findShippedScene(const char* name, const char*) {
    return std::filesystem::path(SW_SOURCE_SCENES) / name;
}
