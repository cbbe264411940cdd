#include <utility>

#include "tools/stability/floats.h"
#include "tools/stability/methods.h"

namespace report {
namespace {

using sw::Triangle;

// Where the ray hits the triangle, and intermediate results.
struct Found {
    float t;
    Vec3 e1, e2;  // edges from vertex 0
    Vec3 n;       // e1 % e2
};

// The slides begin with the point where the ray meets the plane.
bool meetPlane(const Triangle& triangle, const Ray& ray, Found& found, Vec3& fromVertex0) {
    const Vec3& v0 = triangle.vertices[0];
    found.e1 = triangle.vertices[1] - v0;
    found.e2 = triangle.vertices[2] - v0;
    found.n = found.e1 % found.e2;
    found.t = found.n * (v0 - ray.orig) / (found.n * ray.dir);
    if (!ray.contains(found.t)) return false;
    fromVertex0 = ray.orig + found.t * ray.dir - v0;
    return true;
}

// The original: areas as lengths of cross products. A length has no sign, so four times the
// triangle's area is accepted.
bool normBased(const Triangle& triangle, const Ray& ray, Found& found) {
    Vec3 p;
    if (!meetPlane(triangle, ray, found, p)) return false;
    const float area = length(found.n);
    const float v = length(p % found.e2) / area;
    const float w = length(found.e1 % p) / area;
    return v + w <= 1;
}

// The slides' formula with its signs.
bool signedBarycentrics(const Triangle& triangle, const Ray& ray, Found& found) {
    Vec3 p;
    if (!meetPlane(triangle, ray, found, p)) return false;
    const float square = found.n * found.n;
    const float v = (p % found.e2) * found.n / square;
    const float w = (found.e1 % p) * found.n / square;
    return v >= 0 && w >= 0 && v + w <= 1;
}

// Moller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997; without their
// absolute epsilon.
bool mollerTrumbore(const Triangle& triangle, const Ray& ray, Found& found) {
    const Vec3& v0 = triangle.vertices[0];
    found.e1 = triangle.vertices[1] - v0;
    found.e2 = triangle.vertices[2] - v0;
    const Vec3 p = ray.dir % found.e2;
    const float determinant = found.e1 * p;
    if (determinant == 0) return false;
    const float inverse = 1 / determinant;
    const Vec3 s = ray.orig - v0;
    const float v = s * p * inverse;
    if (!(v >= 0 && v <= 1)) return false;
    const Vec3 q = s % found.e1;
    const float w = ray.dir * q * inverse;
    if (!(w >= 0 && v + w <= 1)) return false;
    found.t = found.e2 * q * inverse;
    if (!ray.contains(found.t)) return false;
    found.n = found.e1 % found.e2;
    return true;
}

int dominantAxis(const Vec3& d) {
    const float x = std::fabs(d[0]), y = std::fabs(d[1]), z = std::fabs(d[2]);
    return x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
}

// x y - z w in float, or in double if float cannot decide the sign.
float edge(float x, float y, float z, float w) {
    return x * y - z * w;
}
float exactEdge(double x, double y, double z, double w) {
    return static_cast<float>(x * y - z * w);
}

// Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, JCGT 2013, appendix A.
bool woop(const Triangle& triangle, const Ray& ray, Found& found) {
    const int kz = dominantAxis(ray.dir);
    int kx = kz == 2 ? 0 : kz + 1;
    int ky = kx == 2 ? 0 : kx + 1;
    if (ray.dir[kz] < 0) std::swap(kx, ky);
    const float sx = ray.dir[kx] / ray.dir[kz];
    const float sy = ray.dir[ky] / ray.dir[kz];
    const float sz = 1 / ray.dir[kz];

    const Vec3 a = triangle.vertices[0] - ray.orig;
    const Vec3 b = triangle.vertices[1] - ray.orig;
    const Vec3 c = triangle.vertices[2] - ray.orig;
    const float ax = a[kx] - sx * a[kz], ay = a[ky] - sy * a[kz];
    const float bx = b[kx] - sx * b[kz], by = b[ky] - sy * b[kz];
    const float cx = c[kx] - sx * c[kz], cy = c[ky] - sy * c[kz];

    float u = edge(cx, by, cy, bx), v = edge(ax, cy, ay, cx), w = edge(bx, ay, by, ax);
    if (u == 0 || v == 0 || w == 0) {
        u = exactEdge(cx, by, cy, bx);
        v = exactEdge(ax, cy, ay, cx);
        w = exactEdge(bx, ay, by, ax);
    }
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
    const float determinant = u + v + w;
    if (determinant == 0) return false;
    found.t = sz * (u * a[kz] + v * b[kz] + w * c[kz]) / determinant;
    if (!ray.contains(found.t)) return false;
    found.e1 = b - a;
    found.e2 = c - a;
    found.n = found.e1 % found.e2;
    return true;
}

float sumOfAbs(const Vec3& v) {
    return std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]);
}

template <bool (*find)(const Triangle&, const Ray&, Found&)>
class FloatTriangle : public Triangle {
public:
    explicit FloatTriangle(const Triangle& triangle) : Triangle(triangle) {}

    bool intersect(const Ray& ray, Intersection& hit) const override {
        Found found;
        if (!find(*this, ray, found)) return false;
        fill(hit, ray, found.t, ray.orig + found.t * ray.dir, found.n, found.n * ray.dir < 0,
             sumOfAbs(found.e1) + sumOfAbs(found.e2), material);
        return true;
    }
};

template <typename Kernel>
std::unique_ptr<sw::Primitive> make(const Triangle& triangle) {
    return std::make_unique<Kernel>(triangle);
}

}  // namespace

std::vector<Method<Triangle>> triangleMethods() {
    return {{"norm-based areas (original)", make<FloatTriangle<normBased>>},
            {"signed barycentrics", make<FloatTriangle<signedBarycentrics>>},
            {"Moller-Trumbore", make<FloatTriangle<mollerTrumbore>>},
            {"Woop", make<FloatTriangle<woop>>},
            {"ours", make<Triangle>}};
}

}  // namespace report
