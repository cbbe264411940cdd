#include "app/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <system_error>

#include "nff/plainText.h"

double StopWatch::lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - start;
    start = now;
    return elapsed.count();
}

std::string summary(const Options& options, const sw::RenderResult& result,
                    const StepTimes& times) {
    const auto rays = static_cast<double>(result.rays.total());
    std::ostringstream line = sw::plainStream();
    std::error_code none;
    line << std::filesystem::absolute(options.output, none).lexically_normal().string() << "  "
         << result.image.width() << "x" << result.image.height() << "  "
         << std::round(samplesPerPixel(result) * 100) / 100 << " spp  " << result.threads
         << (result.threads == 1 ? " thread  " : " threads  ") << std::setprecision(3)
         << times.total() << " s  " << rays * 1e-6 << " Mrays  "
         << rays * 1e-6 / std::max(result.seconds, 1e-9) << " Mray/s";
    if (!std::isnan(result.estimatedRmse))
        line << "  rmse " << std::setprecision(2) << result.estimatedRmse << " (est.)";
    return line.str();
}

double samplesPerPixel(const sw::RenderResult& result) {
    const double pixels = static_cast<double>(result.image.width()) * result.image.height();
    return static_cast<double>(result.samples) / pixels;
}
