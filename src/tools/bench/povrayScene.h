#pragma once

#include <string>
#include <vector>

#include "swNff.h"

namespace bench {

/// A scene in the language of POV-Ray 3.7, shaded as traceRay() does: light does not fade, there is
/// none from all around, and the shadow of glass is black. The picture is square.
/// @param shapes  all of the scene
/// @param depth   how many successive reflections and refractions
std::string povrayScene(const sw::NffScene& scene, const std::vector<sw::NffShape>& shapes,
                        int depth);

}  // namespace bench
