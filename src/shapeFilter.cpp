#include "shapeFilter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "simd.h"
#include "swNumerics.h"

namespace sw {
namespace {

using namespace simd;

constexpr float u = num::unitRoundoff;

// Below this, products may have lost their digits to underflow: then nothing is rejected.
constexpr float smallest = 0x1p-100f;

constexpr std::size_t sphereRows = 4;
constexpr std::size_t triangleRows = 10;

struct Float3 {
    Float x, y, z;
};

Float3 spread(const float (&v)[3]) {
    return {broadcast(v[0]), broadcast(v[1]), broadcast(v[2])};
}

Float3 loadRows(const float* row, std::size_t stride) {
    return {load(row), load(row + stride), load(row + 2 * stride)};
}

Float3 operator-(const Float3& a, const Float3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Float dot(const Float3& a, const Float3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Float3 cross(const Float3& a, const Float3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Float largest(const Float3& a) {
    return max(max(abs(a.x), abs(a.y)), abs(a.z));
}

// Rows of `count` values each; reading the last of them as eight stays within the padding.
template <typename Shape, std::size_t rowCount, typename Row>
std::vector<float> makeRows(std::span<const Shape> shapes, std::span<const int> blocks, Row row) {
    std::vector<float> rows;
    rows.reserve(shapes.size() * rowCount + simd::lanes);
    std::size_t first = 0;
    for (const int count : blocks) {
        const auto block = shapes.subspan(first, static_cast<std::size_t>(count));
        for (std::size_t r = 0; r < rowCount; ++r)
            for (const Shape& shape : block) rows.push_back(row(shape, r));
        first += block.size();
    }
    rows.resize(rows.size() + simd::lanes);
    return rows;
}

float triangleRow(const Triangle& triangle, std::size_t r) {
    const Vec3& v0 = triangle.vertices[0];
    const Vec3 edges[2] = {triangle.vertices[1] - v0, triangle.vertices[2] - v0};
    const int axis = static_cast<int>(r % 3);
    if (r < 3) return v0[axis];
    if (r < 9) return edges[r / 3 - 1][axis];
    return std::max(num::maxAbs(edges[0]), num::maxAbs(edges[1]));
}

float sphereRow(const Sphere& sphere, std::size_t r) {
    return r < 3 ? sphere.center[static_cast<int>(r)] : sphere.radius;
}

// An error bound of a few u times x. Infinite, so that nothing is rejected, where terms of the size
// of x come near the end of the range: their sums may have overflowed.
Float bound(float roundings, Float x) {
    return x * 0x1p20f * (roundings * u * 0x1p-20f) + broadcast(smallest);
}

unsigned keep(Mask rejected, int count) {
    return ~bits(rejected) & ((1u << count) - 1);
}

}  // namespace

FilterRay::FilterRay(const Ray& ray) {
    // The power of two comes from the exponent's bits: frexp and ldexp take too long here.
    constexpr std::uint32_t one = 1u << 23;  // in the exponent of a float
    const auto bits = std::bit_cast<std::uint32_t>(num::maxAbs(ray.dir));
    const std::uint32_t exponent = std::max(bits & 0x7f800000u, one) + one;
    const bool tooLong = exponent > 253 * one;  // or not finite
    scale = tooLong ? NAN : std::bit_cast<float>(exponent);
    const float inverse = tooLong ? NAN : std::bit_cast<float>(254 * one - exponent);
    for (int i = 0; i < 3; ++i) {
        orig[i] = ray.orig[i];
        dir[i] = ray.dir[i] * inverse;
    }
    dirSquared = dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2];
    minT = ray.minT * scale;
    maxT = ray.maxT * scale;
}

void SphereFilter::assign(std::span<const Sphere> spheres, std::span<const int> blocks) {
    rows = makeRows<Sphere, sphereRows>(spheres, blocks, sphereRow);
}

// The discriminant b^2 - a (f.f - r^2) in float. Every product in it is at most a (f.f + r^2) and
// has gone through at most 12 roundings, those of a, f and b included: 32u covers both terms.
unsigned SphereFilter::candidates(const FilterRay& ray, std::size_t first, int count) const {
    const auto stride = static_cast<std::size_t>(count);
    const float* row = rows.data() + sphereRows * first;
    const Float3 d = spread(ray.dir);
    const Float3 f = spread(ray.orig) - loadRows(row, stride);
    const Float r = abs(load(row + 3 * stride));
    const Float a = broadcast(ray.dirSquared);

    const Float b = dot(f, d);
    const Float ff = dot(f, f);
    const Float rr = r * r;
    const Float sum = ff + rr;
    const Mask missed = b * b + bound(32, a * sum) < a * (ff - rr);

    // Behind: outside of the sphere and moving away from its centre. |f| |d| <= (f.f + a) / 2.
    const float start = ray.minT >= 0 ? 0 : HUGE_VALF;
    const Mask behind = (b > broadcast(start) + bound(8, ff + a)) & (ff - rr > bound(8, sum));

    // Beyond: every point of the sphere has a t of at least (-b - r |d|) / a, and |d| < 2.
    const Float end = broadcast(ray.maxT) * a;
    const Float nearest = broadcast(0) - b - 2 * r;
    const Mask beyond = nearest - bound(8, ff + a + r) > end * (1 + 8 * u);
    return keep(missed | behind | beyond, count);
}

void TriangleFilter::assign(std::span<const Triangle> triangles, std::span<const int> blocks) {
    rows = makeRows<Triangle, triangleRows>(triangles, blocks, triangleRow);
}

// Moller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997), without its
// division. With components of d up to 1, of s up to S and of the edges up to E, counting the
// roundings of each term gives |error| <= 42u E^2 for det, 42u S E for v and w, 48u S E^2 for t.
unsigned TriangleFilter::candidates(const FilterRay& ray, std::size_t first, int count) const {
    const auto stride = static_cast<std::size_t>(count);
    const float* row = rows.data() + triangleRows * first;
    const Float3 d = spread(ray.dir);
    const Float3 s = spread(ray.orig) - loadRows(row, stride);
    const Float3 e1 = loadRows(row + 3 * stride, stride);
    const Float3 e2 = loadRows(row + 6 * stride, stride);
    const Float extent = load(row + 9 * stride);

    const Float3 p = cross(d, e2);
    const Float3 q = cross(s, e1);
    const Float signedDet = dot(e1, p);
    const Float det = abs(signedDet);
    const Float v = flipSign(dot(s, p), signedDet);
    const Float w = flipSign(dot(d, q), signedDet);
    const Float t = flipSign(dot(e2, q), signedDet);

    const Float area = largest(s) * extent;
    const Float detError = bound(64, extent * extent);
    const Float vwError = bound(64, area);
    const Float tError = bound(64, area * extent);
    const Float none = broadcast(0);
    const Mask signKnown = det > detError;
    const Mask outside =
        (none - vwError > v) | (none - vwError > w) | (v + w > det + detError + 2 * vwError);
    // minT det <= t <= maxT det, with an error of det for either end.
    const Float early = broadcast(ray.minT) * det - abs(broadcast(ray.minT)) * detError;
    const Float late = broadcast(ray.maxT) * (det + detError);
    const Mask beyond = (early > t + tError) | (t - tError > late);
    return keep(signKnown & (outside | beyond), count);
}

}  // namespace sw
