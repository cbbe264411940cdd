#pragma once

#include "nff/nffShapes.h"

// Each function reads one kind of shape; see ReadShape.

namespace sw {

void readSphere(NffShapes& shapes, const Material& material);   ///< s
void readCone(NffShapes& shapes, const Material& material);     ///< c
void readPolygon(NffShapes& shapes, const Material& material);  ///< p
void readPatch(NffShapes& shapes, const Material& material);    ///< pp

/// A triangle's vertices, as --pixel names them.
std::string describeTriangle(const Triangle& triangle);

}  // namespace sw
