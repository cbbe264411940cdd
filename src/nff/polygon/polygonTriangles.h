#pragma once

#include "nff/nffShapes.h"
#include "nff/polygon/triangulate.h"

namespace sw {

/// Cuts the polygon last read into triangles, and warns of one that is not clear.
/// @param use  void(a, b, c): numbers of the vertices of a triangle
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
