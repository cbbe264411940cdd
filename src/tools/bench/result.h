#pragma once

#include <optional>
#include <string>
#include <vector>

namespace bench {

/// What a ratio ought to be.
struct Target {
    enum Kind { atLeast, atMost } kind;
    double value;
};

/// One line of the result: two measurements of the same thing, never one alone.
struct Line {
    std::string what;
    std::string other;  ///< what ours is compared with
    std::string unit;
    double ours = 0;
    double theirs = 0;
    double ratio = 0;  ///< above 1: ours is better where the target is atLeast
    std::optional<Target> target = std::nullopt;

    /// Nothing where there is no target.
    std::optional<bool> met() const;
};

using Lines = std::vector<Line>;

/// As a Markdown table.
std::string toTable(const Lines& lines);

/// @param machine  one line about where this was measured
/// @param notes    what else there is to say
std::string toJson(const Lines& lines, const std::string& machine,
                   const std::vector<std::string>& notes);

}  // namespace bench
