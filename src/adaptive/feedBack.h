#pragma once

#include "adaptive/audit.h"

namespace sw {

/// What is done about what an audit has found. All of it depends on the share's pixels and on
/// blocks of the whole picture alone: it is the same in every window.

/// Puts better pixels in the place of those that have missed something.
/// @param spread  whether the pixels around them are to be sampled as well
/// @return  how much squared error that takes from the window
double repair(AdaptiveGrid& grid, const Audit& audit, const Window& window, bool spread);

/// Has all flat pixels of a block sampled again if what they have missed is more than the
/// tolerance, until it should be less.
/// @param share  of the flat pixels, as lookAtFlat() has looked at
/// @return  whether there is such a block
bool doubtBlocks(AdaptiveGrid& grid, const Audit& audit, double share, const Window& region,
                 float tolerance);

}  // namespace sw
