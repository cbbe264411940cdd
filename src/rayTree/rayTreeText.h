#pragma once

#include <string>

#include "rayTree/rayTree.h"
#include "rayTree/shapeNames.h"

namespace rayTree {

/// The tree as text, two or three lines for every ray, its rays indented below it.
/// @param scene  the tree's scene
std::string describe(const RayTree& tree, const sw::Scene& scene, const ShapeNames& names);

}  // namespace rayTree
