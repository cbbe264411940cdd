#pragma once

#include <string>

namespace scenes {

/// The text of a fractal mountain of 2 * 4^size triangles under four spheres of glass, in NFF: one
/// of the scenes of generators/scenes.h.
std::string mount(int size);

}  // namespace scenes
