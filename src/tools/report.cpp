#include <CLI/CLI.hpp>

#include "tools/common/tool.h"
#include "tools/convergence/convergence.h"
#include "tools/stability/stability.h"

int main(int argc, char** argv) {
    return report::runTool(argc, argv, "swtracer-report", "Measures error against run time.",
                           [](CLI::App& app) {
                               app.require_subcommand(1);
                               report::addStability(app);
                               report::addConvergence(app);
                           });
}
