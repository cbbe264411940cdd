#include <cmath>
#include <sstream>

#include "app/programRun.h"
#include "nff/shippedScenes.h"
#include "swNff.h"

using namespace test;

TEST_CASE("a quick calibration states both errors of every run, and keeps its references") {
    const TemporaryFolder folder;
    const std::string arguments =
        "calibration --quick --output out " + quoted(shippedFolder / "cornell.nff");
    const Run first = runProgram(SW_REPORT, folder, arguments);
    INFO(first.err);
    REQUIRE(first.code == 0);
    CHECK(first.out.find("| --adaptive 0.02 ") != std::string::npos);

    std::istringstream rows(contentOf(folder.path / "out" / "calibration.csv"));
    std::string row;
    std::getline(rows, row);
    CHECK(startsWith(row, "scene,mode,run,spp,seconds,true_rmse,printed_rmse,standard_error,"));
    int runs = 0;
    while (std::getline(rows, row)) {
        CAPTURE(row);
        std::vector<std::string> cells;
        std::istringstream in(row);
        for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
        REQUIRE(cells.size() == 9);
        const double actual = std::stod(cells[5]), printed = std::stod(cells[6]);
        CHECK((actual > 0 && actual < 0.2));
        CHECK(std::fabs(printed - actual) < 3 * std::stod(cells[7]) + std::stod(cells[8]));
        ++runs;
    }
    CHECK(runs == 3);

    std::vector<fs::path> references;
    for (const auto& entry : fs::directory_iterator(folder.path / "out" / "references"))
        references.push_back(entry.path());
    REQUIRE(references.size() >= 1);
    const auto written = fs::last_write_time(references[0]);
    CHECK(runProgram(SW_REPORT, folder, arguments).code == 0);
    CHECK(fs::last_write_time(references[0]) == written);

    const std::string page = contentOf(folder.path / "out" / "index.html");
    CHECK(startsWith(page, "<!DOCTYPE html>"));
    CHECK(page.find("http") == std::string::npos);
}
