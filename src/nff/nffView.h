#pragma once

#include "nff/nffTokens.h"
#include "swVec3.h"

namespace sw {

/// The view of a scene file. Its values are valid and consistent.
struct NffView {
    Vec3 from, at, up;
    float angle = 0;  ///< vertical field of view in degrees
    int width = 512, height = 512;
    const char* statement = nullptr;  ///< where it begins in the text
};

/// Reads the view after its 'v', which must be the last token taken. The format fixes the order;
/// `hither` and `resolution` may be missing.
NffView readView(NffTokens& tokens);

}  // namespace sw
