#include "tools/common/subject.h"

#include <algorithm>
#include <cmath>

#include "swErrorEstimate.h"
#include "swSamplePattern.h"
#include "tools/common/mainFunctions.h"

namespace report {
namespace {

constexpr int depth = 3;
constexpr std::uint64_t referenceSeed = 1000;  // studies have 1, 2, ...

}  // namespace

Subject::Subject(sw::NffScene scene, int size) : file(std::move(scene)) {
    const double scale = static_cast<double>(size) / std::max(file.width, file.height);
    all.x1 = std::max(1, static_cast<int>(std::lround(file.width * scale)));
    all.y1 = std::max(1, static_cast<int>(std::lround(file.height * scale)));
    file.camera.setup(all.x1, all.y1);
    file.scene.prepare();
    radiance = [this](float x, float y) {
        return lab::traceRay(file.camera.getRay(x, y), file.scene, depth);
    };
}

sw::RenderResult Subject::uniformly(sw::SamplePattern pattern, int n, std::uint64_t seed) const {
    const auto pixel = [&](int x, int y) {
        return sw::samplePixelWith(pattern, static_cast<float>(x), static_cast<float>(y), n,
                                   radiance);
    };
    return draw(pixel, pattern, n, seed);
}

sw::RenderResult Subject::reference(int n) const {
    const auto pixel = [&](int x, int y) {
        sw::SampleMean noted;  // for the error estimate
        double sum[3] = {};
        for (const auto& point : sw::samplePoints(sw::SamplePattern::multiJitter, n)) {
            const sw::Color color =
                radiance(static_cast<float>(x) + point.x, static_cast<float>(y) + point.y);
            noted += color;
            for (int i = 0; i < 3; ++i) sum[i] += static_cast<double>(color[i]);
        }
        const auto mean = [&](int i) { return static_cast<float>(sum[i] / n / n); };
        return sw::Color(mean(0), mean(1), mean(2));
    };
    return draw(pixel, sw::SamplePattern::multiJitter, n, referenceSeed);
}

sw::AdaptiveResult Subject::adaptively(const sw::AdaptiveOptions& options) const {
    return sw::renderAdaptive(all, all.x1, all.y1, radiance, options);
}

sw::RenderResult Subject::draw(const std::function<sw::Color(int x, int y)>& pixel,
                               sw::SamplePattern pattern, int n, std::uint64_t seed) const {
    return sw::render(all, pixel, {.seed = seed, .pattern = pattern, .samples = n});
}

}  // namespace report
