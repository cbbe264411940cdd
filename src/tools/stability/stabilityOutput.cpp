#include "tools/stability/stabilityOutput.h"
#include "nff/plainText.h"

#include <algorithm>
#include <iomanip>

#include "tools/common/gnuplot.h"
#include "tools/common/table.h"

namespace report {
namespace {

std::string number(double value, int digits) {
    auto text = sw::plainStream();
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

// Three digits, in powers of ten where it gets long.
std::string rough(double value) {
    auto text = sw::plainStream();
    text << std::setprecision(3) << value;
    return text.str();
}

std::string leaks(const MethodResult& result) {
    return result.leaksPerMillion ? number(*result.leaksPerMillion, 0) : "-";
}

// One panel: time to the right, error upwards, a point per method.
std::string panel(const std::vector<MethodResult>& results, const std::string& shape) {
    auto data = sw::plainStream(), command = sw::plainStream();
    int k = 0;
    for (const MethodResult& result : results) {
        if (result.shape != shape) continue;
        const std::string block = "$" + shape + std::to_string(k++);
        data << block << " << EOD\n"
             << result.nanoseconds << " " << std::max(result.overall.largestError, 0.1)
             << "\nEOD\n";
        command << (k == 1 ? "plot " : ", ") << block << " using 1:2 with points pt " << 3 + 2 * k
                << " ps 1.5 lc " << (result.method == "ours" ? 7 : k) << " title \""
                << result.method << ", " << number(result.overall.wrongPercent, 2) << " % wrong\"";
    }
    return data.str() + "set title '" + shape + "'\n" + command.str() + "\n";
}

}  // namespace

std::string toTable(const std::vector<MethodResult>& results) {
    std::vector<Row> rows{{"method", "ns per call", "time / original's", "wrong hits in %",
                           "largest error of t in ulp", "leaks per million edge rays"}};
    for (const MethodResult& result : results)
        rows.push_back({result.shape + ": " + result.method, number(result.nanoseconds, 1),
                        number(result.ratio, 2), number(result.overall.wrongPercent, 2),
                        rough(result.overall.largestError), leaks(result)});
    return table(rows, 1);
}

std::string toCsv(const std::vector<MethodResult>& results) {
    auto csv = sw::plainStream();
    csv << "shape,method,family,nanoseconds_per_call,time_to_original,wrong_hits_percent,"
           "largest_t_error_ulp,leaks_per_million\n";
    const auto line = [&](const MethodResult& result, const Score& score) {
        csv << result.shape << "," << result.method << "," << score.family << ","
            << result.nanoseconds << "," << result.ratio << "," << score.wrongPercent << ","
            << score.largestError << ",";
        if (result.leaksPerMillion && score.family == "all") csv << *result.leaksPerMillion;
        csv << "\n";
    };
    for (const MethodResult& result : results) {
        line(result, result.overall);
        for (const Score& score : result.families) line(result, score);
    }
    return csv.str();
}

std::string plot(const std::vector<MethodResult>& results, const std::filesystem::path& folder) {
    auto script = sw::plainStream();
    script << "set logscale y\nset format y '10^{%L}'\nset yrange [0.1:]\nset grid\n"
              "set xrange [0:*]\nset offsets 0, graph 0.1, 0, 0\n"
              "set key below vertical maxrows 5 Left reverse\nset bmargin 9\n"
              "set xlabel 'nanoseconds per call'\nset ylabel 'largest error of t in ulp'\n"
              "set multiplot layout 1,2\n"
           << panel(results, "sphere") << panel(results, "triangle") << "unset multiplot\n";
    return drawWithGnuplot(script.str(), folder / "stability", 1100, 480);
}

}  // namespace report
