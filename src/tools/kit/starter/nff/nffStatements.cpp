#include "nff/nffReaders.h"

namespace sw {

std::span<const ShapeStatement> shapeStatements() {
    static constexpr ShapeStatement all[] = {{"s", readSphere}, {"p", readPolygon}};
    return all;
}

}  // namespace sw
