#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/common/powerLaw.h"

namespace report {

/// A row of points in a plot.
struct Curve {
    std::string title;
    std::string style;  ///< gnuplot's, as in "lines lw 2"
    std::vector<Point> points;
};

/// gnuplot's commands that draw some curves into one diagram.
std::string plotCommands(const std::vector<Curve>& curves);

/// Draws a plot as SVG and as PNG.
/// @param script  gnuplot's commands without terminal and output
/// @param name    output path without its extension
/// @return        one line: the files drawn, or why there are none. Does not throw if gnuplot is
///                missing
std::string drawWithGnuplot(const std::string& script, const std::filesystem::path& name, int width,
                            int height);

}  // namespace report
