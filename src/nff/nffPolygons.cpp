#include "nff/nffReaders.h"
#include "nff/plainText.h"
#include "nff/polygon/polygonTriangles.h"

namespace sw {

static std::string describe(const Primitive& shape) {
    return describeTriangle(static_cast<const Triangle&>(shape));
}

std::string describeTriangle(const Triangle& triangle) {
    const Vec3* v = triangle.vertices;
    return plainText(v[0]) + " " + plainText(v[1]) + " " + plainText(v[2]);
}

void readPolygon(NffShapes& shapes, const Material& material) {
    const char* const statement = shapes.tokens.last().begin();
    shapes.readVertices("p", false, "a polygon has three numbers per vertex");
    forEachTriangle(shapes, statement, [&](std::size_t a, std::size_t b, std::size_t c) {
        const std::vector<Vec3>& v = shapes.vertices;
        const Vec3 corners[] = {v[a], v[b], v[c]};
        shapes.push(Triangle(corners, material), statement, "triangle", describe);
    });
}

}  // namespace sw
