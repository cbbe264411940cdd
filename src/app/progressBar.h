#pragma once

#include <functional>

/// A progress bar on stderr, or nothing if stderr is not a terminal. Clears itself at the end.
std::function<void(int done, int total)> makeProgressBar(bool quiet);
