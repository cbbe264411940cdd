#pragma once

#include <filesystem>

namespace bench {

/// Counts the instructions that a ray takes in the lab's picture and the scenes of swtracer-scene,
/// by part of the program, with valgrind. Unlike a time, such a count is the same on every
/// machine. Prints a table, and compares it with the one in instructions.json, if a compiler of the
/// same version made that.
/// @param folder  for temporary files
/// @param accept  writes instructions.json instead of comparing
/// @throws std::runtime_error if a number grew by more than 3 %, or if valgrind is missing
void countInstructions(const std::filesystem::path& folder, bool accept);

}  // namespace bench
