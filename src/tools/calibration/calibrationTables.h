#pragma once

#include <vector>

#include "tools/calibration/calibrationRuns.h"
#include "tools/common/table.h"

namespace report {

/// For each mode, over all scenes: how many of all runs state a true error.
std::vector<Row> modeRows(const std::vector<CalibrationRow>& rows);

/// For each scene and mode.
std::vector<Row> sceneRows(const std::vector<CalibrationRow>& rows);

/// Every run.
std::vector<Row> runRows(const std::vector<CalibrationRow>& rows);

}  // namespace report
