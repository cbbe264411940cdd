#include "nff/nffReaders.h"
#include "nff/plainText.h"

namespace sw {

static std::string describe(const Primitive& shape) {
    const Vec3* v = static_cast<const Triangle&>(shape).vertices;
    return plainText(v[0]) + " " + plainText(v[1]) + " " + plainText(v[2]);
}

// A fan of triangles around the first vertex: right for convex polygons, which suffice here.
void readPolygon(NffShapes& shapes, const Material& material) {
    const char* const statement = shapes.tokens.last().begin();
    shapes.readVertices("p", false, "a polygon has three numbers per vertex");
    const std::vector<Vec3>& v = shapes.vertices;
    for (std::size_t i = 2; i < v.size(); ++i) {
        const Vec3 corners[] = {v[0], v[i - 1], v[i]};
        shapes.push(Triangle(corners, material), statement, "triangle", describe);
        const Vec3 n = (v[1] - v[0]) % (v[2] - v[0]), turn = (v[i - 1] - v[0]) % (v[i] - v[0]);
        if (n * turn < 0)
            shapes.warn(statement, "polygon is not convex",
                        "drawn wrongly; polygons not convex in this file: ");
    }
}

}  // namespace sw
