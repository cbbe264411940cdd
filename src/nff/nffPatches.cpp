#include "nff/nffReaders.h"
#include "nff/polygon/polygonTriangles.h"
#include "swNumerics.h"
#include "swPatch.h"

namespace sw {
namespace {

// Whether a normal points to the back of a triangle.
bool isBelow(const Vec3* v, const Vec3& normal) {
    const auto side = [v](int i) { return num::toDouble(v[i]) - num::toDouble(v[0]); };
    return dot(cross(side(1), side(2)), num::toDouble(normal)) < 0;
}

// In many files the vertices go clockwise, although the normals point outwards. The vertex order
// decides which side is the front, as in the format; the normals only tell how the surface curves.
Patch upwardPatch(const Vec3 (&v)[3], Vec3 (&n)[3], const Material& material) {
    if (isBelow(v, n[0]) && isBelow(v, n[1]) && isBelow(v, n[2]))
        for (Vec3& normal : n) normal = -normal;
    return Patch(v, n, material);
}

std::string describe(const Primitive& shape) {
    return describeTriangle(static_cast<const Patch&>(shape).triangle);
}

}  // namespace

void readPatch(NffShapes& shapes, const Material& material) {
    const char* const statement = shapes.tokens.last().begin();
    shapes.readVertices("pp", true, "a patch has six numbers per vertex");
    forEachTriangle(shapes, statement, [&](std::size_t a, std::size_t b, std::size_t c) {
        const std::vector<Vec3>&v = shapes.vertices, &n = shapes.normals;
        const Vec3 corners[] = {v[a], v[b], v[c]};
        Vec3 directions[] = {n[a], n[b], n[c]};
        shapes.push(upwardPatch(corners, directions, material), statement, "patch", describe);
    });
}

}  // namespace sw
