#include "tools/convergence/convergenceTables.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

const Measurement* find(const Study& study, const std::string& method, const std::string& setting) {
    for (const Measurement& m : study.measurements)
        if (m.method == method && m.setting == setting) return &m;
    return nullptr;
}

// A setting's numbers in all scenes that have it.
std::vector<double> over(const std::vector<Study>& studies, const Measurement& like,
                         double (*number)(const Measurement&)) {
    std::vector<double> values;
    for (const Study& study : studies)
        if (const Measurement* m = find(study, like.method, like.setting))
            values.push_back(number(*m));
    return values;
}

// How many times cheaper the method reaches the error of jitter on this grid.
double speedUp(const Study& study, const std::string& method, const std::string& grid, Cost cost) {
    const Measurement* jitter = find(study, "jitter", grid);
    if (!jitter) return NAN;
    const double own = cost == Cost::seconds ? jitter->seconds : jitter->samples;
    return own / firstReach(curve(study, method, cost), jitter->error.rmse);
}

}  // namespace

std::vector<std::string> methodsOf(const Study& study) {
    std::vector<std::string> methods;
    for (const Measurement& m : study.measurements)
        if (std::find(methods.begin(), methods.end(), m.method) == methods.end())
            methods.push_back(m.method);
    return methods;
}

std::vector<Point> curve(const Study& study, const std::string& method, Cost cost) {
    std::vector<Point> points;
    for (const Measurement& m : study.measurements)
        if (m.method == method)
            points.push_back({cost == Cost::seconds ? m.seconds : m.samples, m.error.rmse});
    return points;
}

PowerLaw slope(const Study& study, const std::string& method, Cost cost) {
    std::vector<Point> points = curve(study, method, cost);
    if (find(study, method, "1x1")) points.erase(points.begin());
    return fitPowerLaw(points);
}

Study overview(const std::vector<Study>& studies) {
    Study all{"overview", sw::Image(1, 1), NAN, {}, {}};
    if (studies.empty()) return all;
    for (Measurement m : studies[0].measurements) {
        const auto mean = [&](auto number) { return geometricMean(over(studies, m, number)); };
        const double samples = mean([](const Measurement& o) { return o.samples; });
        const double seconds = mean([](const Measurement& o) { return o.seconds; });
        const double estimated = mean([](const Measurement& o) { return o.estimatedRmse; });
        const double rmse = mean([](const Measurement& o) { return o.error.rmse; });
        m.rays = mean([](const Measurement& o) { return o.rays; });
        m.error = {.rmse = rmse};
        m.samples = samples;
        m.seconds = seconds;
        m.estimatedRmse = estimated;
        if (over(studies, m, [](const Measurement&) { return 1.0; }).size() == studies.size())
            all.measurements.push_back(m);
    }
    return all;
}

std::string toCsv(const std::vector<Study>& studies) {
    std::vector<Row> rows{{"scene", "method", "setting", "spp", "rays", "seconds", "rmse",
                           "psnr_db", "largest_error", "visible_share", "estimated_rmse"}};
    for (const Study& study : studies)
        for (const Measurement& m : study.measurements)
            rows.push_back({study.scene, m.method, m.setting, rounded(m.samples, 6),
                            rounded(m.rays, 12), rounded(m.seconds, 6), rounded(m.error.rmse, 6),
                            rounded(m.error.psnr, 6), rounded(m.error.largest, 6),
                            rounded(m.error.visible, 6),
                            std::isnan(m.estimatedRmse) ? "" : rounded(m.estimatedRmse, 6)});
    return csv(rows);
}

std::vector<Row> measurementRows(const Study& study) {
    std::vector<Row> rows{{"method", "setting", "samples per pixel", "Mrays", "milliseconds",
                           "RMSE", "estimated RMSE", "PSNR in dB", "largest error",
                           "pixels off by > 2/255 in %"}};
    for (const Measurement& m : study.measurements)
        rows.push_back({m.method, m.setting, rounded(m.samples, 3), rounded(m.rays / 1e6, 3),
                        rounded(1000 * m.seconds, 3), rounded(m.error.rmse, 3),
                        rounded(m.estimatedRmse, 3), fixed(m.error.psnr, 1),
                        rounded(m.error.largest, 2), fixed(100 * m.error.visible, 1)});
    return rows;
}

std::vector<Row> samplerRows(const Study& overview) {
    const std::vector<std::string> grids{"2x2", "3x3", "4x4", "8x8"};
    std::vector<Row> rows{{"method"}};
    for (const std::string& grid : grids) {
        rows[0].push_back("RMSE at " + grid);
        rows[0].push_back("to jitter's");
    }
    for (const std::string& method : methodsOf(overview)) {
        if (!find(overview, method, "1x1")) continue;  // not a sampler
        Row row{method};
        for (const std::string& grid : grids) {
            const Measurement *own = find(overview, method, grid),
                              *jitter = find(overview, "jitter", grid);
            row.push_back(rounded(own ? own->error.rmse : NAN, 3));
            row.push_back(fixed(own && jitter ? own->error.rmse / jitter->error.rmse : NAN, 2));
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<Row> speedUpRows(const std::vector<Study>& studies, Cost cost) {
    const std::vector<std::pair<std::string, std::string>> columns{
        {"multijitter", "3x3"}, {"adaptive", "3x3"}, {"multijitter", "8x8"}, {"adaptive", "8x8"}};
    std::vector<Row> rows{{"scene"}};
    std::vector<std::vector<double>> known(columns.size());
    for (const auto& [method, grid] : columns)
        rows[0].push_back(method + " to the RMSE of jitter " + grid);
    for (const Study& study : studies) {
        Row row{study.scene};
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const double factor = speedUp(study, columns[i].first, columns[i].second, cost);
            if (!std::isnan(factor)) known[i].push_back(factor);
            row.push_back(fixed(factor, 2));
        }
        rows.push_back(row);
    }
    Row means{"geometric mean of these"};
    for (const auto& factors : known) means.push_back(fixed(geometricMean(factors), 2));
    rows.push_back(means);
    return rows;
}

}  // namespace report
