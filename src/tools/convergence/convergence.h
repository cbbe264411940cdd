#pragma once

namespace CLI {
class App;
}

namespace report {

/// Adds `convergence`: error against run time and samples, of all ways to place samples. Throws
/// sw::NffError and sw::FileError when the program runs it.
void addConvergence(CLI::App& app);

}  // namespace report
