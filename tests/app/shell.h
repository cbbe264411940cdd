#pragma once

#include <string>

#include "app/programRun.h"

#ifndef _WIN32

namespace test {

/// Runs a script of the shell in a folder; "$SW" is the program.
/// @param script  without single quotes
inline Run shell(const TemporaryFolder& folder, const std::string& script) {
    return runProgram("sh", folder, "-c '" + script + "'",
                      "SW=" + quoted(SW_PROGRAM) + "; export SW; ");
}

}  // namespace test

#endif
