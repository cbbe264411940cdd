#pragma once

#include "nff/nffTokens.h"
#include "swVec3.h"

namespace sw {

/// The view of a scene file. Its values are valid and consistent.
struct NffView {
    Vec3 from, at, up;
    float angle = 0;  ///< vertical field of view in degrees
    int width = 0, height = 0;
};

/// Reads the view after its 'v', which must be the last token taken. The format fixes the order.
NffView readView(NffTokens& tokens);

}  // namespace sw
