#include "picture.h"

#include "output.h"
#include "swAdaptive.h"
#include "swSampler.h"

namespace {

using Radiance = std::function<sw::Color(float, float)>;

Picture renderAdaptively(const Options& options, const sw::RenderOptions& how,
                         const Radiance& radiance) {
    sw::AdaptiveOptions limits;
    limits.tolerance = options.tolerance;
    limits.targetRmse = options.targetRmse;
    limits.timeLimit = options.timeLimit;
    limits.render = how;
    sw::AdaptiveResult result =
        sw::renderAdaptive(*options.crop, options.width, options.height, radiance, limits);
    result.statistics.estimatedRmse = result.estimatedRmse;
    const double pixels = static_cast<double>(result.image.width()) * result.image.height();
    return {std::move(result.image), std::move(result.errors),
            static_cast<double>(result.samples) / pixels, result.statistics};
}

}  // namespace

Picture renderPicture(const Options& options, const Radiance& radiance,
                      const std::function<sw::Color(int x, int y)>& labPixel) {
    sw::RenderOptions how{.threads = options.threads,
                          .seed = options.seed,
                          .progress = makeProgressBar(options.quiet),
                          .sampler = options.sampler,
                          .samples = options.samples};
    if (options.isAdaptive()) return renderAdaptively(options, how, radiance);

    const sw::Window& window = *options.crop;
    Picture picture{sw::Image(window.width(), window.height()),
                    sw::Image(window.width(), window.height()),
                    static_cast<double>(options.samples) * options.samples,
                    {}};
    how.errors = &picture.errors;
    const auto corner = [&](int x, int y) {
        return radiance(static_cast<float>(x), static_cast<float>(y));
    };
    const auto samplerPixel = [&](int x, int y) {
        return sw::samplePixelWith(options.sampler, static_cast<float>(x), static_cast<float>(y),
                                   options.samples, radiance);
    };
    if (options.corners)
        picture.statistics = sw::renderCorners(picture.image, window, corner, how);
    else if (options.sampler == sw::Sampler::jitter)
        picture.statistics = sw::render(picture.image, window, labPixel, how);
    else
        picture.statistics = sw::render(picture.image, window, samplerPixel, how);
    return picture;
}
