#pragma once

#include <functional>

/// A progress bar on stderr, or nothing where stderr is no terminal. Clears itself at the end.
std::function<void(int done, int total)> makeProgressBar(bool quiet);
