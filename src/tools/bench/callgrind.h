#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace bench {

/// A part of the program: the source files whose path contains one of these texts. Where parts
/// overlap, the first one counts.
struct ProgramPart {
    std::string name;
    std::vector<std::string> files;
};

/// How many instructions each part took, in their order; at the end what belongs to none.
///
/// An inlined function belongs to the part of its own file. What many parts inline, such as vectors
/// and the standard library, belongs to no file's part: it goes along with the lines before it in
/// the function.
/// @param profile  as callgrind writes it, of a program with line numbers
/// @throws std::runtime_error if that is not all that the profile says were counted
std::vector<std::uint64_t> instructionsByPart(std::istream& profile,
                                              const std::vector<ProgramPart>& parts);

}  // namespace bench
