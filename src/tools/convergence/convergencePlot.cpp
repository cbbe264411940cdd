#include "tools/convergence/convergencePlot.h"
#include "nff/plainText.h"

#include <cmath>
#include <iomanip>

#include "tools/common/gnuplot.h"

namespace report {

std::filesystem::path plotName(const Study& study, Cost cost) {
    return study.scene + (cost == Cost::seconds ? "-seconds" : "-samples");
}

std::string plotCurves(const Study& study, Cost cost, const std::filesystem::path& folder) {
    auto data = sw::plainStream(), command = sw::plainStream();
    command << std::fixed << std::setprecision(2);
    int k = 0;  // colour 5 is a yellow too pale for white
    for (const std::string& method : methodsOf(study)) {
        const std::string block = "$curve" + std::to_string(k++);
        data << block << " << EOD\n";
        for (const Point& point : curve(study, method, cost))
            if (point.y > 0) data << point.x << " " << point.y << "\n";
        data << "EOD\n";
        command << (k == 1 ? "plot " : ", ") << block << " using 1:2 with linespoints lw 1.5 pt "
                << 3 + 2 * k << " ps 0.6 lc " << (k == 5 ? 7 : k) << " title \"" << method;
        const double exponent = slope(study, method, cost).exponent;
        if (!std::isnan(exponent)) command << ", slope " << exponent;
        command << "\"";
    }
    auto script = sw::plainStream();
    script << "set logscale xy\nset format '%g'\nset grid\nset key below vertical maxrows 3 Left "
              "reverse\nset ylabel 'RMSE, linear radiance'\nset xlabel '"
           << (cost == Cost::seconds ? "seconds" : "samples per pixel") << "'\n"
           << data.str() << command.str() << "\n";
    return drawWithGnuplot(script.str(), folder / plotName(study, cost), 520, 440);
}

}  // namespace report
