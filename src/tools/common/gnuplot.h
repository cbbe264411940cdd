#pragma once

#include <filesystem>
#include <string>

namespace report {

/// Draws a plot as SVG and as PNG.
/// @param script  gnuplot's commands without terminal and output
/// @param name    where to, without the ending
/// @return        one line: what was drawn, or why nothing was. Never throws for want of gnuplot
std::string drawWithGnuplot(const std::string& script, const std::filesystem::path& name, int width,
                            int height);

}  // namespace report
