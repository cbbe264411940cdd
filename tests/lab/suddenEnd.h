#pragma once

#include <filesystem>
#include <string>

/// A test case may end before its time: by a signal, by exit(), or because it takes too long. Then
/// nothing else tells the report about it, so a file beside the test's record does.
namespace lab {

/// From now on, a sudden end is noted in that file; an old one is removed.
/// @param seconds  after which the program is ended
void expectSuddenEnd(const std::filesystem::path& file, double seconds);

/// The test case has come to its end.
void expectNoSuddenEnd();

/// Notes a signal. Called from its handler.
/// @param name  "SIGSEGV - Segmentation violation signal" for example
void noteSignal(const char* name);

/// Called before the program ends suddenly, unless by a signal: the report is made anew.
extern void (*beforeSuddenEnd)();

}  // namespace lab
