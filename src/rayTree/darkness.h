#pragma once

#include "rayTree/rayNode.h"

namespace rayTree {

/// Why a surface shows less light than it could, one reason per line: there is no light, a light is
/// black or behind the surface, the material scatters nothing, or the depth is used up. Shadows are
/// not among them, they have rays of their own. Empty for a ray that hits nothing.
std::vector<std::string> darkReasons(const RayNode& node, const std::vector<sw::Light>& lights);

}  // namespace rayTree
