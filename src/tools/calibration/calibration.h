#pragma once

#include "tools/common/commandLine.h"

namespace report {

/// Adds `calibration`: how true the printed error is, over scenes, methods and seeds. Throws
/// sw::NffError and sw::FileError when the program runs it.
void addCalibration(CommandLine line);

}  // namespace report
