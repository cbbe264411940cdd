#include "picture.h"

#include "output.h"
// kit >>>
#include "swAdaptive.h"
// <<<
#include "swSampler.h"

namespace {

using Radiance = std::function<sw::Color(float, float)>;
using PixelColor = std::function<sw::Color(int, int)>;

// kit >>>
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

// The colour of a pixel from samples where the sampler says.
PixelColor pixelColor(const Options& options, const Radiance& radiance,
                      const PixelColor& labPixel) {
    if (options.sampler == sw::Sampler::jitter) return labPixel;
    return [&](int x, int y) {
        return sw::samplePixelWith(options.sampler, static_cast<float>(x), static_cast<float>(y),
                                   options.samples, radiance);
    };
}
// <<<

}  // namespace

Picture renderPicture(const Options& options, const Radiance& radiance,
                      const PixelColor& labPixel) {
    sw::RenderOptions how{.threads = options.threads,
                          .seed = options.seed,
                          .progress = makeProgressBar(options.quiet),
                          .sampler = options.sampler,
                          .samples = options.samples};
    // kit >>>
    if (options.isAdaptive()) return renderAdaptively(options, how, radiance);
    // <<<

    const sw::Window& window = *options.crop;
    Picture picture{sw::Image(window.width(), window.height()),
                    sw::Image(window.width(), window.height()),
                    static_cast<double>(options.samples) * options.samples,
                    {}};
    how.errors = &picture.errors;
    const auto corner = [&](int x, int y) {
        return radiance(static_cast<float>(x), static_cast<float>(y));
    };
    // kit >>>
    //| const PixelColor& pixel = labPixel;
    const PixelColor pixel = pixelColor(options, radiance, labPixel);
    // <<<
    picture.statistics = options.corners ? sw::renderCorners(picture.image, window, corner, how)
                                         : sw::render(picture.image, window, pixel, how);
    return picture;
}
