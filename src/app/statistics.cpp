#include "app/statistics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/pixelFaults.h"
#include "swMetrics.h"

namespace {

using sw::RayKind;
using Json = nlohmann::ordered_json;

// Shadow rays that were not cast: the surface faces away from the light or scatters nothing.
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

// null: unknown
Json standardErrorOf(const sw::RenderResult& result) {
    const double error = result.estimatedRmseStandardError;
    return error > 0 ? Json(error) : Json(nullptr);
}

Json secondsOf(const StepTimes& times) {
    return {{"load", times.load},   {"build", times.build}, {"record", times.record},
            {"trace", times.trace}, {"write", times.write}, {"total", times.total()}};
}

}  // namespace

std::string statsJson(const Options& options, const sw::RenderResult& result,
                      const StepTimes& times, const sw::Scene& scene) {
    Json primitives = Json::object();
    for (const auto& [kind, count] : scene.parts().counts) primitives[kind] = count;
    const PixelFaults faults = findFaults(result.image);
    Json json{
        {"width", result.image.width()},
        {"height", result.image.height()},
        {"samples", options.samples},
        {"samples_per_pixel", samplesPerPixel(result)},
        {"corners", options.extra.corners},
        {"depth", options.depth},
        {"threads", result.threads},
        {"seed", options.seed},
        {"sampler", sw::patternNames[static_cast<std::size_t>(options.extra.pattern)]},
        {"estimated_rmse", result.estimatedRmse},
        {"estimated_rmse_standard_error", standardErrorOf(result)},
        {"audited_pixels", result.auditedPixels},
        {"estimated_rmse_8bit", sw::estimatedRmse8bit(result.image, result.errors, options.gamma)},
        {"not_finite_pixels", faults.notFinite.count},
        {"negative_pixels", faults.negative.count},
        {"rough_pixels", result.roughPixels},
        {"rays", raysOf(result.rays)},
        {"left_out", {{"shadow", shadowRaysLeftOut(result.rays, scene)}}},
        {"primitives", primitives},
        {"tree", scene.parts().tree},
        {"seconds", secondsOf(times)}};
    return json.dump(2) + "\n";
}
