#pragma once

#include <filesystem>
#include <string>

#include "tools/convergence/convergenceTables.h"

namespace report {

/// The plots' file names without extension: SCENE-seconds and SCENE-samples.
std::filesystem::path plotName(const Study& study, Cost cost);

/// Draws error against cost, both logarithmic, into a folder, as SVG and as PNG.
/// @return  one line: the files drawn, or why there are none
std::string plotCurves(const Study& study, Cost cost, const std::filesystem::path& folder);

}  // namespace report
