#pragma once

#include <vector>

#include "adaptive/adaptiveGrid.h"
#include "adaptive/coarsePicture.h"
#include "swRenderer.h"

namespace sw {

/// A picture, and how many samples each pixel has, row by row.
struct SampledPicture {
    RenderResult& result;
    std::vector<int>& sampleCounts;
};

/// Takes the memory for a picture. That is most of the work that is left at the end of a rendering:
/// what works against a clock does it first.
void makeBlank(const SampledPicture& picture, const Window& window);

/// Root mean square of the estimated errors of a window.
double estimatedRmse(const AdaptiveGrid& grid, const Window& window);

/// Fills in the pixels and all that is known of them.
void fill(const SampledPicture& picture, const AdaptiveGrid& grid, const Window& window,
          const RenderOptions& options);
void fill(const SampledPicture& picture, const CoarsePicture& coarse, const Window& window,
          const RenderOptions& options);

}  // namespace sw
