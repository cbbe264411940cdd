#include "tools/calibration/calibration.h"
#include "tools/common/commandLine.h"
#include "tools/convergence/convergence.h"
#include "tools/stability/stability.h"

int main(int argc, char** argv) {
    return report::runTool(argc, argv, "swtracer-report", "Measures error against run time.",
                           [](report::CommandLine line) {
                               report::addStability(line);
                               report::addConvergence(line);
                               report::addCalibration(line);
                           });
}
