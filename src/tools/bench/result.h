#pragma once

#include <optional>
#include <string>
#include <vector>

namespace bench {

/// The target of a ratio.
struct Target {
    enum Kind { atLeast, atMost } kind;
    double value;
};

/// One line of the result: always two measurements of the same thing.
struct Line {
    std::string what;
    std::string other;  ///< what ours is compared with
    std::string unit;
    double ours = 0;
    double theirs = 0;
    double ratio = 0;  ///< above 1: ours is better if the target is atLeast
    std::optional<Target> target = std::nullopt;
    /// The ratio for the rays that hit nothing alone, and for the others.
    std::optional<double> misses = std::nullopt, hits = std::nullopt;

    /// Nothing if there is no target.
    std::optional<bool> met() const;
};

using Lines = std::vector<Line>;

/// As a Markdown table.
std::string toTable(const Lines& lines);

/// @param machine  one line about where this was measured
/// @param notes    further remarks
std::string toJson(const Lines& lines, const std::string& machine,
                   const std::vector<std::string>& notes);

}  // namespace bench
