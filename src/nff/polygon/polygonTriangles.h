#pragma once

#include "nff/nffShapes.h"
#include "nff/polygon/triangulate.h"

namespace sw {

/// Triangulates the polygon last read. Warns if it crosses itself or is not planar.
/// @param use  void(a, b, c), called with the indices of each triangle's vertices
template <typename Use>
void forEachTriangle(NffShapes& shapes, const char* statement, const Use& use) {
    constexpr const char* kind =
        "rendered as well as possible; polygons not planar or crossing themselves in this file: ";
    if (shapes.vertices.size() == 3) return use(0, 1, 2);
    const Triangulation result = triangulate(shapes.vertices);
    if (!result.simple)
        shapes.warn(statement, "polygon crosses itself", kind);
    else if (!result.planar)
        shapes.warn(statement, "polygon is not planar", kind);
    for (const auto& [a, b, c] : result.triangles) use(a, b, c);
}

}  // namespace sw
