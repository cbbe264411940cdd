#include "tools/calibration/calibrationPage.h"

#include <algorithm>

#include "tools/calibration/calibrationTables.h"
#include "tools/calibration/nastyScenes.h"
#include "tools/common/gnuplot.h"
#include "tools/common/html.h"

namespace report {
namespace {

namespace fs = std::filesystem;

constexpr const char* plotFile = "over-time";
constexpr const char* plotted = "specks";

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>swTracer: how true the printed error is</title>
<style>
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; margin: 0 auto; padding: 1rem;
  max-width: 70rem; }
figure { margin: 0; max-width: 33rem; }
figcaption { font-size: .85rem; color: #555; }
img { max-width: 100%; height: auto; }
.table { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .85rem; }
th, td { padding: .15rem .6rem; border-bottom: 1px solid #ddd; text-align: left;
  vertical-align: bottom; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
</style></head><body>
<h1>How true the printed error is</h1>
<p>Every scene is rendered with many seeds in every mode. Each picture's true RMSE, against a
converged reference, is compared with the error that the program prints. The nasty scenes have
details below a pixel, and those called <em>fooling</em> were made to fool the estimate.</p>
)";

constexpr const char* aboutPlot = R"(
<h2>Why one sample per pixel is not enough</h2>
<p>Lights of 20 times white cover a few per cent of some pixels. The first samples miss most of them,
and what they saw tells nothing of the rest. The audit looks again at pixels that seem to be flat.</p>
)";

Curve curveOf(const std::string& title, const std::string& style,
              const std::vector<Statement>& runs, double (*value)(const Statement&)) {
    Curve curve{title, style, {}};
    for (const Statement& run : runs)
        if (value(run) > 0) curve.points.push_back({run.seconds, value(run)});
    return curve;
}

std::vector<Statement> statementsOverTime(int size, int referenceGrid, const fs::path& references,
                                          bool quick) {
    const std::vector<NastyScene> all = nastyScenes();
    const auto scene =
        std::find_if(all.begin(), all.end(), [](const NastyScene& s) { return s.name == plotted; });
    const Subject subject(sw::parseNff(scene->text, scene->name), size);
    const Reference reference =
        referenceOf(subject, scene->name, scene->text, referenceGrid, references);
    std::vector<Statement> runs;
    for (double limit = 0.01; limit < (quick ? 0.03 : 2); limit *= 1.5)
        runs.push_back(stateError(subject, {"", Mode::Kind::timeLimit, limit}, 1, reference));
    return runs;
}

}  // namespace

std::string drawOverTime(int size, int referenceGrid, const fs::path& references,
                         const fs::path& folder, bool quick) {
    const auto runs = statementsOverTime(size, referenceGrid, references, quick);
    const std::vector<Curve> curves{
        curveOf("true error", "linespoints lw 2 pt 7 ps 0.6 lc 7", runs,
                [](const Statement& run) { return run.trueRmse; }),
        curveOf("printed error", "linespoints lw 2 pt 5 ps 0.6 lc 3", runs,
                [](const Statement& run) { return run.printed; }),
        curveOf("printed + 3 standard errors", "lines dt 2 lc 3", runs,
                [](const Statement& run) { return run.printed + 3 * run.standardError; }),
        curveOf("printed - 3 standard errors", "lines dt 3 lc 3", runs,
                [](const Statement& run) { return run.printed - 3 * run.standardError; })};
    const std::string settings =
        "set logscale xy\nset format '%g'\nset grid\nset key below vertical maxrows 2 Left "
        "reverse\nset ylabel 'RMSE, linear radiance'\nset xlabel 'seconds'\n";
    return drawWithGnuplot(settings + plotCommands(curves), folder / plotFile, 520, 440);
}

std::string calibrationPage(const std::vector<CalibrationRow>& rows, const fs::path& folder,
                            const std::vector<std::string>& remarks) {
    std::string page = head;
    for (const std::string& remark : remarks) page += "<p>" + html::escaped(remark) + "</p>\n";
    page += "<h2>All scenes</h2>\n" + htmlTable(modeRows(rows), 1);
    const fs::path plot = (folder / plotFile).concat(".svg");
    if (fs::exists(plot))
        page +=
            aboutPlot + html::figure(plot, "true and printed error over the time limit", "plot");
    return page + "<h2>Scene by scene</h2>\n<p>Root mean squares over the seeds.</p>\n" +
           htmlTable(sceneRows(rows), 2) + "</body></html>\n";
}

}  // namespace report
