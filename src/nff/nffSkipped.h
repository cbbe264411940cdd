#pragma once

#include "nff/nffShapes.h"

namespace sw {

// What old files and other dialects hold and we do not use: it is skipped with a warning.

/// Skips a statement of 1990, `number n` or `g x0 x1 y0 y1 z0 z1`, after its keyword.
/// @return  false if the last token taken is none of these
bool skipOldStatement(NffShapes& shapes);

/// Skips the name of a texture, if one stands behind a material's numbers at the end of the line.
/// @param statement  where the material begins in the text
void skipTexture(NffShapes& shapes, const char* statement);

}  // namespace sw
