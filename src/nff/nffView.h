#pragma once

#include "nff/nffTokens.h"
#include "swVec3.h"

namespace sw {

/// What a scene file says about the view. Its values make sense together.
struct NffView {
    Vec3 from, at, up;
    float angle = 0;  ///< vertical field of view in degrees
    int width = 0, height = 0;
};

/// Reads what follows 'v', which must be the last token taken. The format fixes the order.
NffView readView(NffTokens& tokens);

}  // namespace sw
