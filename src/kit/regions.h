#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Two texts in one source: the solution, which is what compiles here, and what students start
/// from. Comments mark the regions that differ, and carry the starter's text:
///
///     // task 1 >>>
///     //| // TODO 1: what is left to do
///     //| return todo::color();
///     return color * cosine;
///     // <<<
///
/// Everything between the marks is the solution but for the lines that begin with `//|`, which are
/// the starter, one level of indentation as the marks. A region may lack either. CMake files have
/// `#` in place of `//`. The name before `>>>` is free, and unique within its file if somebody asks
/// for the region by name; `kit` means "not for students, and no task either".
namespace kit {

/// A source, an edit or a list that makes no sense. The message says where, what was expected and
/// what was found.
class KitError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

struct Region {
    std::string name;      ///< "task 1"
    std::string starter;   ///< whole lines
    std::string solution;  ///< whole lines
};

/// A source cut at its marks.
struct Source {
    /// What stands before each region, and after the last: one text more than there are regions.
    std::vector<std::string> common;
    std::vector<Region> regions;
};

/// @param name  what error messages call the text
/// @throws KitError for a region that does not end, or ends without having begun
Source cut(std::string_view text, const std::string& name);

/// What students get. Several blank lines in a row, where a region left nothing, become one.
std::string starterOf(const Source& source);

/// The solution of one region.
/// @throws KitError unless just one region has that name
const std::string& solutionOf(const Source& source, const std::string& region,
                              const std::string& name);

}  // namespace kit
