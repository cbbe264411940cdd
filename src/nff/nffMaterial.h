#pragma once

#include "nff/nffShapes.h"

namespace sw {

/// Reads a material after its 'f', which must be the last token taken. Warns of odd numbers.
Material readMaterial(NffShapes& shapes);

}  // namespace sw
