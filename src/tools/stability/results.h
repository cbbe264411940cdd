#pragma once

#include <optional>
#include <string>
#include <vector>

namespace report {

/// How often a method is wrong, and by how much.
struct Score {
    std::string family;
    double wrongPercent = 0;  ///< wrong decisions: hits reported as misses, or the reverse
    double largestError = 0;  ///< of t, in ulp, over the correctly found hits
};

/// One line of the report.
struct MethodResult {
    std::string shape;
    std::string method;
    double nanoseconds = 0;                 ///< per call
    double ratio = 0;                       ///< time / time of the original's formula
    std::optional<double> leaksPerMillion;  ///< of rays at edges shared by two triangles
    Score overall;                          ///< all families together
    std::vector<Score> families;
};

}  // namespace report
