#pragma once

#include <memory>
#include <string>

#include "swPrimitive.h"

namespace sw {

/// A shape as a scene file describes it. A polygon of more than three vertices is several.
struct NffShape {
    using Describe = std::string (*)(const Primitive&);

    std::shared_ptr<const Primitive> primitive;
    int line;                     ///< where its statement begins; the first line is 1
    const char* kind = "other";   ///< its name in the format
    Describe describe = nullptr;  ///< "centre (0, 1, 0), radius 2" for example; null: nothing
};

}  // namespace sw
