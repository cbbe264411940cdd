#include "swPatch.h"

#include <algorithm>

#include "swNumerics.h"

namespace sw {
namespace {

using glm::dvec3;

dvec3 side(const Triangle& triangle, int i) {
    return num::toDouble(triangle.vertices[i]) - num::toDouble(triangle.vertices[0]);
}

// As close to unit length as floats get: scaling such a normal again would only change last digits.
bool isUnit(const dvec3& n) {
    return std::fabs(dot(n, n) - 1) <= 8 * num::unitRoundoff;
}

// n scaled to unit length; `fallback` if n has no direction.
Vec3 normalOr(const dvec3& n, const Vec3& fallback) {
    return num::toFloat(isUnit(n) ? n : num::unitOr(n, num::toDouble(fallback)));
}

// The point v0 + v (v1 - v0) + w (v2 - v0) of a triangle.
struct Barycentric {
    double v, w;
};

// Signed areas relative to the whole triangle. At a vertex they are exactly 0 or 1. The point was
// rounded and may lie just outside: hence the clamps.
Barycentric barycentric(const Triangle& triangle, const Vec3& point) {
    const dvec3 e1 = side(triangle, 1), e2 = side(triangle, 2), n = cross(e1, e2);
    const dvec3 p = num::toDouble(point) - num::toDouble(triangle.vertices[0]);
    const double area = dot(n, n);
    const double v = std::clamp(dot(cross(p, e2), n) / area, 0.0, 1.0);
    return {v, std::clamp(dot(cross(e1, p), n) / area, 0.0, 1 - v)};
}

}  // namespace

Patch::Patch(const Vec3* v, const Vec3* n, const Material& material)
    : Primitive(material), triangle(v, material) {
    const Vec3 own = normalOr(cross(side(triangle, 1), side(triangle, 2)), Vec3());
    for (int i = 0; i < 3; ++i) normals[i] = normalOr(num::toDouble(n[i]), own);
}

bool Patch::intersect(const Ray& ray, Intersection& hit) const {
    if (!triangle.intersect(ray, hit)) return false;
    hit.material = material;
    hit.geometricNormal = hit.normal;

    const auto [v, w] = barycentric(triangle, hit.position);
    const dvec3 n0 = num::toDouble(normals[0]);
    const dvec3 outward =
        n0 + v * (num::toDouble(normals[1]) - n0) + w * (num::toDouble(normals[2]) - n0);
    hit.setFace(normalOr(outward, Vec3()), hit.frontFacing);
    const dvec3 shading = num::toDouble(hit.normal);
    const bool isAbove = dot(shading, num::toDouble(hit.geometricNormal)) > 0;
    const bool facesRay = dot(shading, num::toDouble(ray.dir)) < 0;
    if (!(isAbove && facesRay)) hit.normal = hit.geometricNormal;
    return true;
}

}  // namespace sw
