#pragma once

/// The program: reads the command line, renders with traceRay() and samplePixel(), and writes what
/// was asked for.
/// @return  exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output. A failure is
///          explained by one line on stderr
int runProgram(int argc, const char* const* argv);
