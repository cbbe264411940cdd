#include "tools/calibration/calibrationTables.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace report {
namespace {

/// How many of some runs state a true error.
struct Score {
    int runs = 0, near = 0, inBand = 0, meantTarget = 0;

    void add(const CalibrationRow& row) {
        for (const Statement& run : row.runs) {
            ++runs;
            near += row.isNear(run);
            inBand += row.isInBand(run);
            meantTarget += row.meansTarget(run);
        }
    }
    Row cells(bool hasTarget) const {
        return {percent(near), percent(inBand), hasTarget ? percent(meantTarget) : "-"};
    }

private:
    std::string percent(int count) const { return fixed(100. * count / std::max(runs, 1), 1); }
};

double rootMeanSquare(const CalibrationRow& row, double Statement::*number) {
    double sum = 0;
    for (const Statement& run : row.runs) sum += run.*number * (run.*number);
    return std::sqrt(sum / static_cast<double>(row.runs.size()));
}

bool hasTarget(const Mode& mode) {
    return mode.kind == Mode::Kind::targetRmse;
}

void append(Row& row, const Row& cells) {
    row.insert(row.end(), cells.begin(), cells.end());
}

}  // namespace

std::vector<Row> modeRows(const std::vector<CalibrationRow>& rows) {
    std::vector<Row> table{{"mode", "runs", "within a factor of 1.5, in %",
                            "within 3 standard errors, in %", "at most 1.2 targets, in %"}};
    std::vector<Mode> modes;
    for (const CalibrationRow& row : rows)
        if (std::none_of(modes.begin(), modes.end(),
                         [&](const Mode& mode) { return mode.name == row.mode.name; }))
            modes.push_back(row.mode);
    for (const Mode& mode : modes) {
        Score score;
        for (const CalibrationRow& row : rows)
            if (row.mode.name == mode.name) score.add(row);
        Row cells{mode.name, std::to_string(score.runs)};
        append(cells, score.cells(hasTarget(mode)));
        table.push_back(cells);
    }
    return table;
}

std::vector<Row> sceneRows(const std::vector<CalibrationRow>& rows) {
    std::vector<Row> table{{"scene", "mode", "samples per pixel", "true RMSE", "printed",
                            "standard error", "factor 1.5, %", "3 standard errors, %",
                            "1.2 targets, %"}};
    for (const CalibrationRow& row : rows) {
        Score score;
        score.add(row);
        Row cells{row.scene,
                  row.mode.name,
                  rounded(rootMeanSquare(row, &Statement::samples), 3),
                  rounded(rootMeanSquare(row, &Statement::trueRmse), 3),
                  rounded(rootMeanSquare(row, &Statement::printed), 3),
                  rounded(rootMeanSquare(row, &Statement::standardError), 2)};
        append(cells, score.cells(hasTarget(row.mode)));
        table.push_back(cells);
    }
    return table;
}

std::vector<Row> runRows(const std::vector<CalibrationRow>& rows) {
    std::vector<Row> table{{"scene", "mode", "run", "spp", "seconds", "true_rmse", "printed_rmse",
                            "standard_error", "reference_error"}};
    for (const CalibrationRow& row : rows)
        for (std::size_t i = 0; i < row.runs.size(); ++i) {
            const Statement& run = row.runs[i];
            table.push_back({row.scene, row.mode.name, std::to_string(i + 1),
                             rounded(run.samples, 6), rounded(run.seconds, 6),
                             rounded(run.trueRmse, 6), rounded(run.printed, 6),
                             rounded(run.standardError, 6), rounded(row.referenceError, 6)});
        }
    return table;
}

}  // namespace report
