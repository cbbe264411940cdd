#include "app/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <system_error>
#include <utility>

#include "nff/plainText.h"

double StopWatch::lap() {
    const auto before = std::exchange(start, std::chrono::steady_clock::now());
    return std::chrono::duration<double>(start - before).count();
}

std::string summary(const Options& options, const sw::RenderResult& result,
                    const StepTimes& times) {
    const auto rays = static_cast<double>(result.rays.total());
    std::ostringstream line = sw::plainStream();
    std::error_code none;
    const auto place = std::filesystem::absolute(options.output, none).lexically_normal();
    line << (options.output.has_extension() ? place : options.output).string() << "  "
         << result.image.width() << "x" << result.image.height() << "  "
         << std::round(samplesPerPixel(result) * 100) / 100 << " spp  " << result.threads
         << (result.threads == 1 ? " thread  " : " threads  ") << std::setprecision(3)
         << times.total() << " s  " << rays * 1e-6 << " Mrays  "
         << rays * 1e-6 / std::max(result.seconds, 1e-9) << " Mray/s";
    const double rmse = result.estimatedRmse, error = result.estimatedRmseStandardError;
    if (!std::isnan(rmse)) line << "  rmse " << std::setprecision(2) << rmse;
    if (error > 0) line << " +- " << std::setprecision(1) << error;
    if (!std::isnan(rmse)) line << " (est.)";
    return line.str();
}

double samplesPerPixel(const sw::RenderResult& result) {
    return static_cast<double>(result.samples) / result.image.width() / result.image.height();
}
