#pragma once

#include "rayTree/rayNode.h"

namespace rayTree {

/// The kit gives no reasons.
inline std::vector<std::string> darkReasons(const RayNode&, const std::vector<sw::Light>&) {
    return {};
}

}  // namespace rayTree
