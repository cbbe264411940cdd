#include "app/picture.h"

#include "app/progressBar.h"
#include "app/sampling.h"

sw::RenderResult renderPicture(const Options& options,
                               const std::function<sw::Color(float x, float y)>& radiance,
                               const std::function<sw::Color(int x, int y)>& samplePixel) {
    const sw::RenderOptions how{.threads = options.threads,
                                .seed = options.seed,
                                .progress = makeProgressBar(options.quiet),
                                .pattern = options.sampling.pattern,
                                .samples = options.samples};
    if (auto result = renderOtherwise(options, how, radiance)) return std::move(*result);
    const auto corner = [&](int x, int y) {
        return radiance(static_cast<float>(x), static_cast<float>(y));
    };
    return options.corners ? sw::renderCorners(*options.crop, corner, how)
                           : sw::render(*options.crop, samplePixel, how);
}
