#include "swTriangle.h"

#include <algorithm>

#include "swNumerics.h"

// The lab's formula: with e1 = v1 - v0 and e2 = v2 - v0, the plane of normal n = e1 % e2 is met at
//     t = n * (v0 - orig) / (n * dir),   Q = orig + t dir,   r = Q - v0,
// and Q = v0 + w e1 + v e2 lies inside where its barycentric coordinates
//     v = (e1 % r) * n / (n * n),   w = (r % e2) * n / (n * n)
// obey v >= 0, w >= 0 and v + w <= 1. Keep the sign: norms in place of the dot products with n
// accept four times the area. In floats, and with Q computed first, neighbours can disagree about a
// ray through their common edge, and it slips between them.
//
// This code follows Woop, Benthin and Wald, Watertight Ray/Triangle Intersection (JCGT 2013). Each
// vertex is projected along the ray onto a coordinate plane; three edge functions tell on which
// side of its edges the ray passes. A vertex is projected in the same way for all of its triangles,
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
    explicit Projection(const Ray& ray) : axes(axesOf(ray.dir)) {
        ox = ray.orig.m[axes.x];
        oy = ray.orig.m[axes.y];
        oz = ray.orig.m[axes.z];
        dx = ray.dir.m[axes.x];
        dy = ray.dir.m[axes.y];
        dz = ray.dir.m[axes.z];
    }

    // Woop's shear times dz, which spares the division: x dz - z dx instead of x - z dx / dz.
    Projected operator()(const Vec3& v) const {
        const double x = v.m[axes.x] - ox, y = v.m[axes.y] - oy, z = v.m[axes.z] - oz;
        return {x * dz - z * dx, y * dz - z * dy, z};
    }

    double along() const { return dz; }

private:
    struct Axes {
        unsigned char x, y, z;  // right-handed; the direction is longest along z
    };

    // From a table: a branch on the direction would be unpredictable.
    static const Axes& axesOf(const Vec3& d) {
        static constexpr Axes table[2][2] = {{{0, 1, 2}, {0, 1, 2}}, {{2, 0, 1}, {1, 2, 0}}};
        const float x = std::fabs(d.m[0]), y = std::fabs(d.m[1]), z = std::fabs(d.m[2]);
        return table[std::max(x, y) > z][x > y];
    }

    Axes axes;
    double ox, oy, oz;
    double dx, dy, dz;
};

// Twice the signed area between the ray and the edge from p to q.
double edge(const Projected& p, const Projected& q) {
    return p.x * q.y - p.y * q.x;
}

// Whether the area of a triangle with edges e1, e2 and normal n = e1 x e2 is more than rounding:
// each term of n carries an error of a few 2^-53 |e1| |e2|.
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

    const double u = edge(b, c), w = edge(c, a), v = edge(a, b);
    // One test of all signs, as branches on each would be unpredictable.
    const double lowest = std::min(u, std::min(w, v)), highest = std::max(u, std::max(w, v));
    if (static_cast<int>(lowest < 0) & static_cast<int>(highest > 0)) return false;

    // No float comes near an overflow. Seen edge-on, the scale is infinite and t is NaN, as all
    // edge functions are 0.
    const double scale = 1 / ((u + w + v) * project.along());
    const double t = (u * a.z + w * b.z + v * c.z) * scale;
    const float rounded = static_cast<float>(t);
    if (!ray.contains(rounded)) return false;

    const dvec3 v0 = num::toDouble(vertices[0]);
    const dvec3 e1 = num::toDouble(vertices[1]) - v0;
    const dvec3 e2 = num::toDouble(vertices[2]) - v0;
    const dvec3 n = cross(e1, e2);
    if (!hasArea(n, e1, e2)) return false;

    const double weight = project.along() * scale;
    hit.hitT = rounded;
    hit.position = num::toFloat(v0 + w * weight * e1 + v * weight * e2);
    hit.setFace(num::toFloat(1 / std::sqrt(dot(n, n)) * n), dot(n, num::toDouble(ray.dir)) < 0);
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
