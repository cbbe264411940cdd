#include "nffShapes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "swNumerics.h"
#include "triangulate.h"

namespace sw {
namespace {

// A limit against files that ask for absurd amounts of work.
constexpr float mostVertices = 1000000;

// Whether a normal points below a triangle.
bool isBelow(const Vec3* v, const Vec3& normal) {
    const auto side = [v](int i) { return num::toDouble(v[i]) - num::toDouble(v[0]); };
    return dot(cross(side(1), side(2)), num::toDouble(normal)) < 0;
}

bool haveOppositeSigns(float a, float b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

}  // namespace

void NffShapes::Oddity::note(const char* at, const char* reason) {
    if (count++ > 0) return;
    first = at;
    what = reason;
}

std::vector<std::string> NffShapes::warnings() const {
    std::vector<std::string> lines;
    const auto add = [&](const Oddity& oddity, const char* summary) {
        if (oddity.count > 0)
            lines.push_back(tokens.place(oddity.first) + "warning: " + oddity.what + " (" +
                            summary + std::to_string(oddity.count) + ")");
    };
    add(unclearPolygons,
        "rendered as well as possible; polygons not planar or crossing themselves in this file: ");
    add(flatCones, "left out; cones without height in this file: ");
    return lines;
}

template <typename Shape>
void NffShapes::push(const Shape& shape, const char* statement) {
    scene.push(shape);
    if (!listed) return;
    line += static_cast<int>(std::count(counted, statement, '\n'));
    counted = statement;
    listed->push_back({std::make_shared<Shape>(shape), line});
}

void NffShapes::readSphere(const Material& material) {
    const char* const statement = tokens.last().begin();
    float v[4];
    tokens.numbers("s", v, 4, "is the radius missing?");
    if (v[3] == 0) tokens.failAtLast("expected a radius other than 0");
    push(Sphere(Vec3(v[0], v[1], v[2]), v[3], material), statement);
}

void NffShapes::readCone(const Material& material) {
    const char* const statement = tokens.last().begin();
    float v[8];
    tokens.numbers("c", v, 8, "base and apex, each a point and a radius");
    const Vec3 base(v[0], v[1], v[2]), apex(v[4], v[5], v[6]);
    const float baseRadius = v[3], apexRadius = v[7];
    if (haveOppositeSigns(baseRadius, apexRadius))
        tokens.failAtLast("expected two radii of the same sign");
    if (baseRadius == 0 && apexRadius == 0)
        tokens.failAtLast("expected a radius other than 0 at one end at least");
    // Some exporters write lids as cones without height, and others thin cones in too few digits.
    if ((apex - base).isZero()) return flatCones.note(statement, "cone has no height");
    push(Cone(base, baseRadius, apex, apexRadius, material), statement);
}

void NffShapes::readPolygon(const Material& material) {
    const char* const statement = tokens.last().begin();
    const int count = readVertexCount("p");
    readVertices({"p", 3 * count, "a polygon has three numbers per vertex"}, false);
    cut(statement, [&](std::size_t a, std::size_t b, std::size_t c) {
        const Vec3 corners[] = {vertices[a], vertices[b], vertices[c]};
        push(Triangle(corners, material), statement);
    });
}

void NffShapes::readPatch(const Material& material) {
    const char* const statement = tokens.last().begin();
    const int count = readVertexCount("pp");
    readVertices({"pp", 6 * count, "a patch has six numbers per vertex"}, true);
    cut(statement, [&](std::size_t a, std::size_t b, std::size_t c) {
        push(patch(a, b, c, material), statement);
    });
}

// Many files go round clockwise and yet have normals that point outwards. The order says which side
// is the front, as the format demands; the normals say how the surface bends, from either side.
Patch NffShapes::patch(std::size_t a, std::size_t b, std::size_t c,
                       const Material& material) const {
    const Vec3 v[] = {vertices[a], vertices[b], vertices[c]};
    Vec3 n[] = {normals[a], normals[b], normals[c]};
    if (isBelow(v, n[0]) && isBelow(v, n[1]) && isBelow(v, n[2]))
        for (Vec3& normal : n) normal = -normal;
    return Patch(v, n, material);
}

int NffShapes::readVertexCount(const char* keyword) {
    float count;
    tokens.numbers(keyword, &count, 1);
    if (!(count >= 3 && count <= mostVertices && count == std::floor(count)))
        tokens.failAtLast("expected a number of vertices from 3 to 1000000");
    return static_cast<int>(count);
}

// Memory grows with the numbers found, not with what the file promises.
void NffShapes::readVertices(const NffTokens::Group& group, bool withNormals) {
    vertices.clear();
    normals.clear();
    Vec3 v;
    for (int i = 0; i < group.size; i += 3) {
        tokens.numbers(group, i, v.m, 3);
        (withNormals && i % 2 == 1 ? normals : vertices).push_back(v);
    }
}

template <typename PushTriangle>
void NffShapes::cut(const char* statement, const PushTriangle& pushTriangle) {
    if (vertices.size() == 3) return pushTriangle(0, 1, 2);
    const Triangulation result = triangulate(vertices);
    if (!result.simple)
        unclearPolygons.note(statement, "polygon crosses itself");
    else if (!result.planar)
        unclearPolygons.note(statement, "polygon is not planar");
    for (const auto& [a, b, c] : result.triangles) pushTriangle(a, b, c);
}

}  // namespace sw
