#pragma once

#include <vector>

#include "adaptive/adaptiveGrid.h"
#include "adaptive/coarsePicture.h"
#include "swRenderer.h"

namespace sw {

/// A picture that is to be filled in.
struct SampledPicture {
    RenderResult& result;
    std::vector<int>& sampleCounts;  ///< row by row
    bool details = true;             ///< whether errors and sampleCounts are wanted

    std::size_t bytesPerPixel() const {
        return sizeof(Color) + (details ? sizeof(Color) + sizeof(int) : 0);
    }
};

/// Makes all pixels black, with an error of zero.
/// @return  how many seconds one thread takes to get a byte of memory from the system: for a huge
///          picture, that is most of the time that is needed to fill it in
double makeBlank(const SampledPicture& picture, const Window& window);

/// Root mean square of the estimated errors of a window.
double estimatedRmse(const AdaptiveGrid& grid, const Window& window);

/// Fills in the pixels and all that is known of them.
void fill(const SampledPicture& picture, const AdaptiveGrid& grid, const Window& window,
          const RenderOptions& options);
void fill(const SampledPicture& picture, const CoarsePicture& coarse, const Window& window,
          const RenderOptions& options);

}  // namespace sw
