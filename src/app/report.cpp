#include "app/report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "nff/plainText.h"
#include "swErrorEstimate.h"

namespace {

using sw::RayKind;
using Json = nlohmann::ordered_json;

double samplesPerPixel(const sw::RenderResult& result) {
    const double pixels = static_cast<double>(result.image.width()) * result.image.height();
    return static_cast<double>(result.samples) / pixels;
}

// Shadow rays that a surface did not need, as it faces away from the light or scatters nothing.
std::uint64_t shadowRaysLeftOut(const sw::RayCount& rays, const sw::Scene& scene) {
    const std::uint64_t all = rays.shaded() * scene.lights().size(), cast = rays[RayKind::shadow];
    return std::max(all, cast) - cast;
}

Json raysOf(const sw::RayCount& rays) {
    return {
        {"primary", rays[RayKind::primary]},     {"primary_hits", rays.hitsOf(RayKind::primary)},
        {"shadow", rays[RayKind::shadow]},       {"reflected", rays[RayKind::reflected]},
        {"refracted", rays[RayKind::refracted]}, {"other", rays[RayKind::other]}};
}

Json secondsOf(const StepTimes& times) {
    return {{"load", times.load},
            {"build", times.build},
            {"trace", times.trace},
            {"write", times.write},
            {"total", times.total()}};
}

}  // namespace

double StopWatch::lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - start;
    start = now;
    return elapsed.count();
}

void printWarnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) std::cerr << "swtracer: " << warning << std::endl;
}

std::string summary(const Options& options, const sw::RenderResult& result,
                    const StepTimes& times) {
    const auto rays = static_cast<double>(result.rays.total());
    std::ostringstream line = sw::plainStream();
    line << std::filesystem::absolute(options.output).lexically_normal().string() << "  "
         << result.image.width() << "x" << result.image.height() << "  "
         << std::round(samplesPerPixel(result) * 100) / 100 << " spp  " << result.threads
         << (result.threads == 1 ? " thread  " : " threads  ") << std::setprecision(3)
         << times.total() << " s  " << rays * 1e-6 << " Mrays  "
         << rays * 1e-6 / std::max(result.seconds, 1e-9) << " Mray/s";
    if (!std::isnan(result.estimatedRmse))
        line << "  rmse " << std::setprecision(2) << result.estimatedRmse << " (est.)";
    return line.str();
}

std::string statsJson(const Options& options, const sw::RenderResult& result,
                      const StepTimes& times, const sw::Scene& scene) {
    Json primitives = Json::object();
    for (const auto& [kind, count] : scene.parts().counts) primitives[kind] = count;
    Json json{
        {"width", result.image.width()},
        {"height", result.image.height()},
        {"samples", options.samples},
        {"samples_per_pixel", samplesPerPixel(result)},
        {"corners", options.sampling.corners},
        {"depth", options.depth},
        {"threads", result.threads},
        {"seed", options.seed},
        {"sampler", sw::patternNames[static_cast<std::size_t>(options.sampling.pattern)]},
        {"estimated_rmse", result.estimatedRmse},
        {"estimated_rmse_8bit", sw::estimatedRmse8bit(result.image, result.errors, options.gamma)},
        {"rays", raysOf(result.rays)},
        {"left_out", {{"shadow", shadowRaysLeftOut(result.rays, scene)}}},
        {"primitives", primitives},
        {"tree", scene.parts().tree},
        {"seconds", secondsOf(times)}};
    return json.dump(2) + "\n";
}
