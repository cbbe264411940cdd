#include "nff/nffReaders.h"

namespace sw {

std::span<const ShapeStatement> shapeStatements() {
    static constexpr ShapeStatement all[] = {
        {"s", readSphere}, {"c", readCone}, {"p", readPolygon}, {"pp", readPatch}};
    return all;
}

}  // namespace sw
