#pragma once

#include "tools/common/commandLine.h"

namespace report {

/// Adds `stability`: error against run time of intersection kernels. Throws sw::FileError when
/// the program runs it and its output cannot be written.
void addStability(CommandLine line);

}  // namespace report
