#include "tools/stability/oracle.h"

#include <cfloat>
#include <cmath>

namespace report {
namespace {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Real = __float128;
constexpr Real epsilon = 0x1p-112;
#else
using Real = long double;
constexpr Real epsilon = LDBL_EPSILON;
#endif

struct Vector {
    Real x, y, z;
};

Vector exact(const sw::Vec3& v) {
    return {v.m[0], v.m[1], v.m[2]};
}
Vector operator-(const Vector& u, const Vector& v) {
    return {u.x - v.x, u.y - v.y, u.z - v.z};
}
Real dot(const Vector& u, const Vector& v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}
Vector cross(const Vector& u, const Vector& v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
Real magnitude(Real x) {
    return x < 0 ? -x : x;
}

// Two Newton steps extend double's 53 bits to 113.
Real squareRoot(Real x) {
    Real root = std::sqrt(static_cast<double>(x));
    if (!(root > 0)) return root;
    for (int i = 0; i < 2; ++i) root = (root + x / root) / 2;
    return root;
}

// Any sign tested here results from fewer than 50 roundings. Each is off by at most epsilon times
// `scale`, the product of the lengths involved.
bool isCertain(Real value, Real scale) {
    return magnitude(value) > 64 * epsilon * scale;
}

const Truth uncertain{false, false, 0};
const Truth miss{true, false, 0};

// A hit whose t fits a float.
Truth hitAt(Real t) {
    if (!(t > FLT_MIN && t < FLT_MAX / 2)) return uncertain;
    return {true, true, static_cast<long double>(t)};
}

int sign(Real x) {
    return x > 0 ? 1 : -1;
}

}  // namespace

Truth exactHit(const sw::Sphere& sphere, const sw::Ray& ray) {
    const Vector d = exact(ray.dir);
    const Vector f = exact(ray.orig) - exact(sphere.center);
    const Real square = static_cast<Real>(sphere.radius) * sphere.radius;
    const Vector x = cross(f, d);
    const Real a = dot(d, d), ff = dot(f, f), b = -dot(f, d);

    const Real discriminant = square * a - dot(x, x);
    if (!isCertain(discriminant, (square + ff) * a)) return uncertain;
    if (discriminant < 0) return miss;

    const Real c = ff - square;
    if (!isCertain(c, square + ff)) return uncertain;  // starts on the surface
    const Real root = squareRoot(discriminant);
    if (c < 0) return hitAt(b > 0 ? (b + root) / a : c / (b - root));  // from inside
    return b > 0 ? hitAt(c / (b + root)) : miss;                       // in front, or behind
}

Truth exactHit(const sw::Triangle& triangle, const sw::Ray& ray) {
    const Vector d = exact(ray.dir);
    const Vector o = exact(ray.orig);
    const Vector a = exact(triangle.vertices[0]) - o;
    const Vector b = exact(triangle.vertices[1]) - o;
    const Vector c = exact(triangle.vertices[2]) - o;

    // Six times the signed volume between the ray and each edge.
    const Real u = dot(d, cross(b, c)), v = dot(d, cross(c, a)), w = dot(d, cross(a, b));
    const Real longest = dot(a, a) + dot(b, b) + dot(c, c);
    const Real scale = longest * squareRoot(dot(d, d));
    if (!isCertain(u, scale) || !isCertain(v, scale) || !isCertain(w, scale)) return uncertain;
    if (sign(u) != sign(v) || sign(v) != sign(w)) return miss;

    const Vector n = cross(b - a, c - a);
    const Real height = dot(n, a);
    if (!isCertain(height, longest * squareRoot(longest))) return uncertain;  // starts on the plane
    if (sign(height) != sign(dot(n, d))) return miss;                         // behind
    return hitAt(height / dot(n, d));
}

}  // namespace report
