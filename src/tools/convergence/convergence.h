#pragma once

#include "tools/common/commandLine.h"

namespace report {

/// Adds `convergence`: error against run time and samples, for all sampling methods. Throws
/// sw::NffError and sw::FileError when the program runs it.
void addConvergence(CommandLine line);

}  // namespace report
