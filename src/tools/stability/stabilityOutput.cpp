#include "tools/stability/stabilityOutput.h"

#include <algorithm>

#include "tools/common/gnuplot.h"
#include "tools/common/table.h"

namespace report {
namespace {

// One panel: time to the right, error upwards, a point per method.
std::string panel(const std::vector<MethodResult>& results, const std::string& shape) {
    std::vector<Curve> points;
    for (const MethodResult& result : results) {
        if (result.shape != shape) continue;
        const std::size_t k = points.size() + 1;
        points.push_back({result.method + ", " + fixed(result.overall.wrongPercent, 2) + " % wrong",
                          "points pt " + std::to_string(3 + 2 * k) + " ps 1.5 lc " +
                              std::to_string(result.method == "ours" ? 7 : k),
                          {{result.nanoseconds, std::max(result.overall.largestError, 0.1)}}});
    }
    return "set title '" + shape + "'\n" + plotCommands(points);
}

Row csvRow(const MethodResult& result, const Score& score) {
    const bool leaks = result.leaksPerMillion && score.family == "all";
    return {result.shape,
            result.method,
            score.family,
            rounded(result.nanoseconds, 6),
            rounded(result.ratio, 6),
            rounded(score.wrongPercent, 6),
            rounded(score.largestError, 6),
            leaks ? rounded(*result.leaksPerMillion, 6) : ""};
}

}  // namespace

std::string toTable(const std::vector<MethodResult>& results) {
    std::vector<Row> rows{{"method", "ns per call", "time / original's", "wrong hits in %",
                           "largest error of t in ulp", "leaks per million edge rays"}};
    for (const MethodResult& result : results)
        rows.push_back({result.shape + ": " + result.method, fixed(result.nanoseconds, 1),
                        fixed(result.ratio, 2), fixed(result.overall.wrongPercent, 2),
                        rounded(result.overall.largestError, 3),
                        result.leaksPerMillion ? fixed(*result.leaksPerMillion, 0) : "-"});
    return table(rows, 1);
}

std::string toCsv(const std::vector<MethodResult>& results) {
    std::vector<Row> rows{{"shape", "method", "family", "nanoseconds_per_call", "time_to_original",
                           "wrong_hits_percent", "largest_t_error_ulp", "leaks_per_million"}};
    for (const MethodResult& result : results) {
        rows.push_back(csvRow(result, result.overall));
        for (const Score& score : result.families) rows.push_back(csvRow(result, score));
    }
    return csv(rows);
}

std::string plot(const std::vector<MethodResult>& results, const std::filesystem::path& folder) {
    const std::string settings =
        "set logscale y\nset format y '10^{%L}'\nset yrange [0.1:]\nset grid\n"
        "set xrange [0:*]\nset offsets 0, graph 0.1, 0, 0\n"
        "set key below vertical maxrows 5 Left reverse\nset bmargin 9\n"
        "set xlabel 'nanoseconds per call'\nset ylabel 'largest error of t in ulp'\n"
        "set multiplot layout 1,2\n";
    return drawWithGnuplot(
        settings + panel(results, "sphere") + panel(results, "triangle") + "unset multiplot\n",
        folder / "stability", 1100, 480);
}

}  // namespace report
