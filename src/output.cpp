#include "output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <locale>
#include <sstream>
#include <utility>

#include "swErrorEstimate.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace {

using Clock = std::chrono::steady_clock;
using sw::LeftOut;
using sw::RayKind;

bool stderrIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

// Formats numbers the same way in every locale.
std::ostringstream plainStream() {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    return stream;
}

void drawBar(int done, int total, double seconds) {
    constexpr int width = 40;
    std::ostringstream line = plainStream();
    line << "\r[" << std::string(static_cast<std::size_t>(done * width / total), '#')
         << std::string(static_cast<std::size_t>(width - done * width / total), ' ') << "] "
         << std::setw(3) << done * 100 / total << " %  " << std::fixed << std::setprecision(1)
         << seconds * (total - done) / done << " s left ";
    std::cerr << line.str() << std::flush;
}

// Parts of the engine that had nothing to do, as strings of JSON.
std::string notNeeded(const sw::SceneParts& parts, const sw::RayCount& rays,
                      const sw::Scene& scene) {
    const std::pair<const char*, bool> needs[] = {{"tree", parts.tree},
                                                  {"spheres", parts.spheres > 0},
                                                  {"triangles", parts.triangles > 0},
                                                  {"cones", parts.cones > 0},
                                                  {"patches", parts.patches > 0},
                                                  {"other primitives", parts.others > 0},
                                                  {"lights", !scene.lights().empty()},
                                                  {"shadows", rays[RayKind::shadow] > 0},
                                                  {"reflection", rays[RayKind::reflected] > 0},
                                                  {"refraction", rays[RayKind::refracted] > 0}};
    std::string list;
    for (const auto& [name, needed] : needs)
        if (!needed) list += (list.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    return list;
}

// JSON has no NaN.
std::string orNull(double number) {
    if (std::isnan(number)) return "null";
    std::ostringstream text = plainStream();
    text << std::setprecision(4) << number;
    return text.str();
}

constexpr const char* clearLine = "\r\x1b[K";

}  // namespace

double StopWatch::lap() {
    const auto now = Clock::now();
    const std::chrono::duration<double> elapsed = now - start;
    start = now;
    return elapsed.count();
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "swtracer: " << warning << std::endl;
}

std::function<void(int done, int total)> makeProgressBar(bool quiet) {
    if (quiet || !stderrIsTerminal()) return nullptr;
    const auto start = Clock::now();
    return [start, drawn = start](int done, int total) mutable {
        const auto now = Clock::now();
        const bool visible = drawn != start;
        if (done == total) {
            if (visible) std::cerr << clearLine << std::flush;
        } else if (now - drawn > std::chrono::milliseconds(100)) {
            drawn = now;
            drawBar(done, total, std::chrono::duration<double>(now - start).count());
        }
    };
}

std::string summary(const Options& options, const Picture& picture, const StepTimes& times) {
    const sw::RenderStatistics& rendered = picture.statistics;
    const auto rays = static_cast<double>(rendered.rays.total());
    std::ostringstream line = plainStream();
    line << std::filesystem::absolute(options.output).lexically_normal().string() << "  "
         << options.crop->width() << "x" << options.crop->height() << "  "
         << std::round(picture.samplesPerPixel * 100) / 100 << " spp  " << rendered.threads
         << (rendered.threads == 1 ? " thread  " : " threads  ") << std::setprecision(3)
         << times.total() << " s  " << rays * 1e-6 << " Mrays  "
         << rays * 1e-6 / std::max(rendered.seconds, 1e-9) << " Mray/s";
    if (!std::isnan(rendered.estimatedRmse))
        line << "  rmse " << std::setprecision(2) << rendered.estimatedRmse << " (est.)";
    return line.str();
}

std::string statsJson(const Options& options, const Picture& picture, const StepTimes& times,
                      const sw::Scene& scene) {
    const sw::RenderStatistics& rendered = picture.statistics;
    const double steps = sw::estimatedSteps(picture.image, picture.errors, options.gamma);
    const sw::RayCount& rays = rendered.rays;
    const sw::SceneParts parts = scene.parts();
    std::ostringstream json = plainStream();
    json << std::setprecision(6) << "{\n"
         << "  \"width\": " << options.crop->width() << ",\n"
         << "  \"height\": " << options.crop->height() << ",\n"
         << "  \"samples\": " << options.samples << ",\n"
         << "  \"samples_per_pixel\": " << picture.samplesPerPixel << ",\n"
         << "  \"corners\": " << (options.corners ? "true" : "false") << ",\n"
         << "  \"depth\": " << options.depth << ",\n"
         << "  \"threads\": " << rendered.threads << ",\n"
         << "  \"seed\": " << options.seed << ",\n"
         << "  \"sampler\": \"" << sw::samplerNames[static_cast<std::size_t>(options.sampler)]
         << "\",\n"
         << "  \"estimated_rmse\": " << orNull(rendered.estimatedRmse) << ",\n"
         << "  \"estimated_rmse_8bit\": " << orNull(steps) << ",\n"
         << "  \"rays\": {\"primary\": " << rays[RayKind::primary]
         << ", \"primary_hits\": " << rays.primaryHits << ", \"shadow\": " << rays[RayKind::shadow]
         << ", \"reflected\": " << rays[RayKind::reflected]
         << ", \"refracted\": " << rays[RayKind::refracted]
         << ", \"other\": " << rays[RayKind::other] << "},\n"
         << "  \"left_out\": {\"shadow_zero_weight\": " << rays[LeftOut::shadowZeroWeight]
         << ", \"shadow_facing_away\": " << rays[LeftOut::shadowFacingAway]
         << ", \"secondary_zero_weight\": " << rays[LeftOut::secondaryZeroWeight] << "},\n"
         << "  \"primitives\": {\"spheres\": " << parts.spheres
         << ", \"triangles\": " << parts.triangles << ", \"cones\": " << parts.cones
         << ", \"patches\": " << parts.patches << ", \"other\": " << parts.others << "},\n"
         << "  \"not_needed\": [" << notNeeded(parts, rays, scene) << "],\n"
         << "  \"seconds\": {\"load\": " << times.load << ", \"build\": " << times.build
         << ", \"trace\": " << times.trace << ", \"write\": " << times.write
         << ", \"total\": " << times.total() << "}\n"
         << "}\n";
    return json.str();
}
