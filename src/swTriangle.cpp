#include "swTriangle.h"

#include "swNumerics.h"

// The lab's formula: the plane through v0 with n = (v1 - v0) % (v2 - v0) is met at
//     t = n * (v0 - orig) / (n * dir),   p = orig + t dir,
// and p lies inside where its barycentric coordinates
//     v = ((p - v0) % (v2 - v0)) * n / (n * n),   w = ((v1 - v0) % (p - v0)) * n / (n * n)
// obey v >= 0, w >= 0 and v + w <= 1. Keep the sign: norms in place of the dot products with n
// accept four times the area. In floats, and with p computed first, neighbours can disagree about a
// ray through their common edge, and it slips between them.
//
// Here instead: Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (JCGT 2013). Each
// vertex is projected along the ray onto a coordinate plane; three edge functions tell on which
// side of its edges the ray passes. A vertex is projected the same way for all of its triangles,
// and rounding never turns the sign of a b - c d into its opposite, only into 0. So neighbours
// cannot both say "outside". FMA instructions would break this: see -ffp-contract in
// CMakeLists.txt.

namespace sw {
namespace {

using glm::dvec3;

// A vertex seen from the ray: x and y across it, z along the axis that the ray follows most.
struct Projected {
    double x, y, z;
};

class Projection {
public:
    explicit Projection(const Ray& ray) : kz(dominantAxis(ray.dir)) {
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        for (int i = 0; i < 3; ++i) o[i] = ray.orig.m[i];
        dx = ray.dir.m[kx];
        dy = ray.dir.m[ky];
        dz = ray.dir.m[kz];
    }

    // Woop's shear times dz, which spares the division: x dz - z dx instead of x - z dx / dz.
    Projected operator()(const Vec3& v) const {
        const double x = v.m[kx] - o[kx], y = v.m[ky] - o[ky], z = v.m[kz] - o[kz];
        return {x * dz - z * dx, y * dz - z * dy, z};
    }

    double along() const { return dz; }

private:
    static int dominantAxis(const Vec3& d) {
        const float x = std::fabs(d.m[0]), y = std::fabs(d.m[1]), z = std::fabs(d.m[2]);
        return x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    }

    int kx, ky, kz;
    double o[3];
    double dx, dy, dz;
};

// Twice the signed area between the ray and the edge from p to q.
double edge(const Projected& p, const Projected& q) {
    return p.x * q.y - p.y * q.x;
}

// The normal of a triangle whose area is not lost in rounding: each term of e1 x e2 carries an
// error of a few 2^-53 |e1| |e2|.
bool hasArea(const dvec3& n, const dvec3& e1, const dvec3& e2) {
    return dot(n, n) > 0x1p-100 * dot(e1, e1) * dot(e2, e2);
}

float sumOfAbs(const dvec3& v) {
    return static_cast<float>(std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z));
}

}  // namespace

bool Triangle::intersect(const Ray& ray, Intersection& hit) const {
    const Projection project(ray);
    const Projected a = project(vertices[0]);
    const Projected b = project(vertices[1]);
    const Projected c = project(vertices[2]);

    const double u = edge(b, c), v = edge(c, a), w = edge(a, b);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const double area = u + v + w;
    if (area == 0) return false;  // seen edge-on

    const double t = (u * a.z + v * b.z + w * c.z) / (area * project.along());
    const float rounded = static_cast<float>(t);
    if (!(ray.minT < rounded && rounded < ray.maxT)) return false;  // outside, or NaN

    const dvec3 v0 = num::toDouble(vertices[0]);
    const dvec3 e1 = num::toDouble(vertices[1]) - v0;
    const dvec3 e2 = num::toDouble(vertices[2]) - v0;
    const dvec3 n = cross(e1, e2);
    if (!hasArea(n, e1, e2)) return false;

    hit.hitT = rounded;
    hit.position = num::toFloat(v0 + (v / area) * e1 + (w / area) * e2);
    hit.frontFacing = dot(n, num::toDouble(ray.dir)) < 0;
    hit.normal = num::toFloat(glm::normalize(hit.frontFacing ? n : -n));
    hit.material = material;
    hit.ray = ray;
    hit.positionError = num::surfaceError(hit.position, sumOfAbs(e1) + sumOfAbs(e2));
    return true;
}

Bounds Triangle::bounds() const {
    Bounds box;
    for (const Vec3& v : vertices) box.add(v);
    return box;
}

}  // namespace sw
