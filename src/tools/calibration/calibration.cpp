#include "tools/calibration/calibration.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "app/scenePath.h"
#include "app/usage.h"
#include "swFile.h"
#include "tools/calibration/calibrationPage.h"
#include "tools/calibration/calibrationRuns.h"
#include "tools/calibration/calibrationTables.h"
#include "tools/calibration/nastyScenes.h"
#include "tools/common/machine.h"
#include "tools/common/scenes/scenes.h"
#include "tools/common/tool.h"

namespace report {
namespace {

namespace fs = std::filesystem;

struct CalibrationOptions {
    std::vector<fs::path> scenes;
    fs::path output = "report/calibration";
    int size = 128;
    int seeds = 50;
    bool quick = false;
};

// How much of it all is done.
struct CalibrationEffort {
    int size, seeds, referenceGrid;
    std::vector<Mode> modes;
};

CalibrationEffort effortFor(const CalibrationOptions& options) {
    using Kind = Mode::Kind;
    if (options.quick)
        return {std::min(options.size, 32),
                1,
                8,
                {{"--adaptive 0.02", Kind::tolerance, 0.02},
                 {"--target-rmse 0.01", Kind::targetRmse, 0.01},
                 {"--samples 3", Kind::grid, 3}}};
    return {options.size,
            options.seeds,
            64,
            {{"--adaptive 0.02", Kind::tolerance, 0.02},
             {"--adaptive 0.01", Kind::tolerance, 0.01},
             {"--target-rmse 0.01", Kind::targetRmse, 0.01},
             {"--target-rmse 0.005", Kind::targetRmse, 0.005},
             {"--time-limit 0.5", Kind::timeLimit, 0.5},
             {"--samples 3", Kind::grid, 3}}};
}

// The generators' scenes, small: they are slow, and their details are as fine.
std::vector<NastyScene> generatedScenes() {
    std::vector<NastyScene> all;
    for (const scenes::Generator& g : scenes::generators)
        all.push_back({g.name, g.generate(std::max(g.least, g.usual / 2))});
    return all;
}

std::vector<NastyScene> scenesFor(const CalibrationOptions& options) {
    std::vector<NastyScene> all;
    const auto add = [&](const fs::path& file) {
        all.push_back({file.stem().string(), sw::readFile(file)});
    };
    for (const fs::path& file : options.scenes) add(file);
    if (!all.empty()) return all;
    std::vector<fs::path> shipped;
    for (const auto& entry :
         fs::directory_iterator(findShippedScene("cornell.nff", "").parent_path()))
        if (entry.path().extension() == ".nff") shipped.push_back(entry.path());
    std::sort(shipped.begin(), shipped.end());
    if (options.quick) shipped.resize(1);
    for (const fs::path& file : shipped) add(file);
    if (!options.quick)
        for (const NastyScene& scene : generatedScenes()) all.push_back(scene);
    for (const NastyScene& scene : nastyScenes()) all.push_back(scene);
    return all;
}

// The modes take turns: if the machine slows down, it does so for all of them alike.
std::vector<CalibrationRow> calibrate(const NastyScene& scene, const CalibrationEffort& effort,
                                      const fs::path& folder) {
    const Subject subject(sw::parseNff(scene.text, scene.name), effort.size);
    const Reference reference =
        referenceOf(subject, scene.name, scene.text, effort.referenceGrid, folder);
    std::vector<CalibrationRow> rows;
    for (const Mode& mode : effort.modes) rows.push_back({scene.name, mode, reference.error, {}});
    for (int seed = 1; seed <= effort.seeds; ++seed)
        for (CalibrationRow& row : rows)
            row.runs.push_back(
                stateError(subject, row.mode, static_cast<std::uint64_t>(seed), reference));
    return rows;
}

void run(const CalibrationOptions& options) {
    const fs::path csvFile = outputFile(options.output, "calibration.csv");
    const fs::path page = options.output / "index.html";
    const fs::path references = outputFile(options.output / "references", "x").parent_path();
    const CalibrationEffort effort = effortFor(options);

    std::vector<CalibrationRow> rows;
    for (const NastyScene& scene : scenesFor(options)) {
        for (CalibrationRow& row : calibrate(scene, effort, references))
            rows.push_back(std::move(row));
        std::cout << scene.name << std::endl;
    }
    sw::writeFile(csvFile, csv(runRows(rows)));
    std::vector<std::string> remarks{machine()};
    if (options.quick) remarks.push_back(quickRemark);
    const std::string drawn =
        drawOverTime(effort.size, effort.referenceGrid, references, options.output, options.quick);
    if (drawn.starts_with("no plot")) remarks.push_back(drawn + "; the tables have the numbers");
    sw::writeFile(page, calibrationPage(rows, options.output, remarks));

    for (const std::string& remark : remarks) std::cout << "\n" << remark << "\n";
    std::cout << "\n" << table(sceneRows(rows), 2) << "\n" << table(modeRows(rows), 1) << "\n";
    for (const fs::path& file : {csvFile, page})
        std::cout << fs::absolute(file).lexically_normal().string() << std::endl;
}

}  // namespace

void addCalibration(CommandLine line) {
    const auto options = std::make_shared<CalibrationOptions>();
    CommandLine command = line.addCommand(
        "calibration", "How true the printed error is: true against printed, for many seeds.");
    command.addFiles("scenes", options->scenes,
                     "scene files (default: shipped and generated scenes, and nasty ones)");
    command.addFolder("-o,--output", options->output,
                      "folder for index.html, calibration.csv and references");
    command.addSize("--size", options->size, 8, 2048, "pixels of the pictures' longer side");
    command.addSize("--seeds", options->seeds, 1, 1000, "renders of each scene in each mode");
    command.addFlag("--quick", options->quick, "tiny pictures: only check that it works");
    command.setWork([options] { run(*options); });
}

}  // namespace report
