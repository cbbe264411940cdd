#include "tools/convergence/convergence.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

#include "app/scenePath.h"
#include "app/usage.h"
#include "swFile.h"
#include "tools/common/machine.h"
#include "tools/common/tool.h"
#include "tools/convergence/convergencePage.h"
#include "tools/convergence/convergencePlot.h"
#include "tools/convergence/convergenceTables.h"
#include "tools/convergence/study.h"

namespace report {
namespace {

namespace fs = std::filesystem;

struct ConvergenceOptions {
    std::vector<fs::path> scenes;
    fs::path output = "report/convergence";
    int size = 128;
    bool quick = false;
};

StudyEffort effortFor(const ConvergenceOptions& options) {
    if (options.quick)
        return {.size = std::min(options.size, 24),
                .largestGrid = 2,
                .repetitions = 1,
                .tolerances = {0.1f, 0.02f},
                .referenceGrid = 8};
    return {.size = options.size,
            .tolerances = {0.2f, 0.1f, 0.05f, 0.03f, 0.02f, 0.01f, 0.005f, 0.002f}};
}

std::vector<fs::path> shippedScenes() {
    std::vector<fs::path> scenes;
    for (const auto& entry :
         fs::directory_iterator(findShippedScene("cornell.nff", "").parent_path()))
        if (entry.path().extension() == ".nff") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

// The scenes' names become names of files and sections.
void requireDifferentNames(const std::vector<fs::path>& scenes) {
    std::set<fs::path> names{"overview"};
    for (const fs::path& scene : scenes)
        if (!names.insert(scene.stem()).second)
            throw UsageError(scene.string() + ": expected scenes of different names, found '" +
                             scene.stem().string() + "' again (give the file another name)");
}

std::vector<Study> studyAll(const std::vector<fs::path>& scenes, const StudyEffort& effort) {
    std::vector<Study> studies;
    for (const fs::path& scene : scenes) {
        studies.push_back(studyScene(scene, effort));
        std::cout << studies.back().scene << std::endl;
    }
    return studies;
}

std::string drawPlots(const std::vector<Study>& studies, const Study& all, const fs::path& folder) {
    std::string said;
    for (const Cost cost : {Cost::seconds, Cost::samples}) {
        for (const Study& study : studies) plotCurves(study, cost, folder);
        said = plotCurves(all, cost, folder);
    }
    return said;
}

void run(const ConvergenceOptions& options) {
    const auto scenes = options.scenes.empty() ? shippedScenes() : options.scenes;
    requireDifferentNames(scenes);
    const fs::path csv = outputFile(options.output, "convergence.csv");
    const fs::path page = options.output / "index.html";

    const std::vector<Study> studies = studyAll(scenes, effortFor(options));
    const Study all = overview(studies);
    sw::writeFile(csv, toCsv(studies));
    std::vector<std::string> remarks{machine()};
    if (options.quick) remarks.push_back(quickRemark);
    const std::string drawn = drawPlots(studies, all, options.output);
    if (drawn.starts_with("no plot")) remarks.push_back(drawn + "; the tables have the numbers");
    sw::writeFile(page, convergencePage(studies, all, options.output, remarks));

    for (const std::string& remark : remarks) std::cout << "\n" << remark << "\n";
    std::cout << "\n"
              << table(samplerRows(all), 1) << "\nTimes less run time than jitter:\n\n"
              << table(speedUpRows(studies, Cost::seconds), 1) << "\n";
    for (const fs::path& file : {csv, page})
        std::cout << fs::absolute(file).lexically_normal().string() << std::endl;
}

}  // namespace

void addConvergence(CommandLine line) {
    const auto options = std::make_shared<ConvergenceOptions>();
    CommandLine command = line.addCommand(
        "convergence", "Error against run time and samples, for all sampling methods.");
    command.addFiles("scenes", options->scenes, "scene files (default: all shipped scenes)");
    command.addFolder("-o,--output", options->output,
                      "folder for index.html, convergence.csv and pictures");
    command.addSize("--size", options->size, 8, 2048, "pixels of the pictures' longer side");
    command.addFlag("--quick", options->quick, "tiny pictures: only check that it works");
    command.setWork([options] { run(*options); });
}

}  // namespace report
