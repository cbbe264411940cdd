#pragma once

namespace CLI {
class App;
}

namespace report {

/// Adds `stability`: error against run time of intersection kernels. Throws sw::FileError when
/// the program runs it and its output cannot be written.
void addStability(CLI::App& app);

}  // namespace report
