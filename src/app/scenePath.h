#pragma once

#include <filesystem>

/// The path of a scene that comes with the program: beside the installed program, or in the source
/// tree that it was built from.
/// @param program  argv[0]
std::filesystem::path findShippedScene(const char* name, const char* program);
