#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/calibration/calibrationRuns.h"

namespace report {

/// Draws true error, printed error and its band over the time limit, for lights of a fraction of a
/// pixel: the first samples miss most of them.
/// @return  one line: the files drawn, or why there are none
std::string drawOverTime(int size, int referenceGrid, const std::filesystem::path& references,
                         const std::filesystem::path& folder, bool quick);

/// The page, with the plot if it was drawn.
std::string calibrationPage(const std::vector<CalibrationRow>& rows,
                            const std::filesystem::path& folder,
                            const std::vector<std::string>& remarks);

}  // namespace report
