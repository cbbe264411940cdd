#include "tools/convergence/convergencePlot.h"

#include <cmath>

#include "tools/common/gnuplot.h"

namespace report {

std::filesystem::path plotName(const Study& study, Cost cost) {
    return study.scene + (cost == Cost::seconds ? "-seconds" : "-samples");
}

std::string plotCurves(const Study& study, Cost cost, const std::filesystem::path& folder) {
    std::vector<Curve> curves;
    for (const std::string& method : methodsOf(study)) {
        Curve shown{method, "", {}};
        const double exponent = slope(study, method, cost).exponent;
        if (!std::isnan(exponent)) shown.title += ", slope " + fixed(exponent, 2);
        const std::size_t k = curves.size() + 1;
        shown.style = "linespoints lw 1.5 pt " + std::to_string(3 + 2 * k) + " ps 0.6 lc " +
                      std::to_string(k == 5 ? 7 : k);  // colour 5 is a yellow, too pale on white
        for (const Point& point : curve(study, method, cost))
            if (point.y > 0) shown.points.push_back(point);
        curves.push_back(shown);
    }
    const std::string settings =
        "set logscale xy\nset format '%g'\nset grid\nset key below vertical maxrows 3 Left "
        "reverse\nset ylabel 'RMSE, linear radiance'\nset xlabel '" +
        std::string(cost == Cost::seconds ? "seconds" : "samples per pixel") + "'\n";
    return drawWithGnuplot(settings + plotCommands(curves), folder / plotName(study, cost), 520,
                           440);
}

}  // namespace report
