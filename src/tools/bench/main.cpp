#include <filesystem>
#include <iostream>

#include "swFile.h"
#include "tools/bench/instructions.h"
#include "tools/bench/parts.h"
#include "tools/bench/picture.h"
#include "tools/common/commandLine.h"
#include "tools/common/machine.h"
#include "tools/common/tool.h"

namespace {

void run(const bench::Setup& setup) {
    const std::filesystem::path file = report::outputFile(setup.output, "bench.json");
    std::vector<std::string> notes;
    if (!bench::embreesPicture(16)) notes.push_back("Embree 3 is not installed: lines left out");
    if (!bench::isPovRayInstalled())
        notes.push_back("POV-Ray 3.7 is not installed: lines left out");
    if (setup.quick) notes.push_back(report::quickRemark);

    bench::Lines lines;
    bench::compareLab(setup, lines);
    bench::comparePovRay(setup, lines);
    bench::measureSteps(setup, lines);
    bench::measureLoading(setup, lines);
    bench::compareModels(setup, lines);
    bench::measureGrowth(setup, lines);

    std::cout << report::machine() << "\n\n" << bench::toTable(lines);
    for (const std::string& note : notes) std::cout << "\n" << note << "\n";
    sw::writeFile(file, bench::toJson(lines, report::machine(), notes));
    std::cout << "\n" << file.string() << std::endl;
}

void countInstructions(const bench::Setup& setup, bool accept) {
    std::filesystem::create_directories(setup.output);
    bench::countInstructions(setup.output, accept);
}

}  // namespace

int main(int argc, char** argv) {
    bench::Setup setup;
    bool instructions = false, accept = false;
    return report::runTool(
        argc, argv, "swtracer-bench",
        "Compares run times and memory with other programs; prints ratios.",
        [&](report::CommandLine line) {
            line.addFlag("--quick", setup.quick, "only check that everything runs");
            line.addFlag("--full", setup.full, "also models of 4 and 10 million triangles");
            line.addFolder("--output", setup.output, "folder for bench.json");
            line.addChoice("instructions", instructions,
                           "Counts instructions per ray, with valgrind; fails if there are more "
                           "than in instructions.json.")
                .addFlag("--accept", accept, "write instructions.json anew");
            line.setWork([&] { instructions ? countInstructions(setup, accept) : run(setup); });
        });
}
