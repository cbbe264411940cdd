#include "accel/shapePackets.h"

#include <algorithm>

#include "accel/filterKernels.h"

namespace sw {
namespace {

std::uint32_t takeFirst(std::vector<std::uint32_t>& numbers) {
    const std::uint32_t first = numbers.front();
    numbers.erase(numbers.begin());
    return first;
}

bool same(const Vec3& a, const Vec3& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// Two triangles make a parallelogram if they share an edge, and the corner across from it, mirrored
// at the edge's middle, is the other triangle's third vertex. Returns that corner, or -1.
int parallelogramCorner(const Triangle& triangle, const Triangle& other) {
    const auto& a = triangle.vertices;
    const auto& b = other.vertices;
    for (int i = 0; i < 9; ++i) {
        const int corner = i / 3, far = i % 3;
        const Vec3 &p = a[(corner + 1) % 3], &q = a[(corner + 2) % 3];
        const Vec3 &r = b[(far + 1) % 3], &s = b[(far + 2) % 3];
        if (!(same(p, r) && same(q, s)) && !(same(p, s) && same(q, r))) continue;
        const glm::dvec3 mirrored = num::toDouble(p) + num::toDouble(q) - num::toDouble(a[corner]);
        if (mirrored == num::toDouble(b[far])) return corner;
    }
    return -1;
}

}  // namespace

SpherePacket::SpherePacket(std::span<const Sphere> all, std::vector<std::uint32_t>& pending) {
    for (std::size_t lane = 0; lane < simd::lanes && !pending.empty(); ++lane) {
        numbers[lane] = takeFirst(pending);
        used |= 1u << lane;
        const Sphere& sphere = all[numbers[lane]];
        for (int i = 0; i < 3; ++i) center[i][lane] = sphere.center[i];
        radius[lane] = std::fabs(sphere.radius);
    }
}

unsigned SpherePacket::candidates(const FilterRay& ray) const {
    const Float3 f = spread(ray.orig) - loadRows(center[0], simd::lanes);
    return used & ~bits(spheresMissed(ray, f, load(radius)));
}

TrianglePacket::TrianglePacket(std::span<const Triangle> all, std::vector<std::uint32_t>& pending) {
    for (std::size_t lane = 0; lane < simd::lanes && !pending.empty(); ++lane) {
        numbers[lane] = takeFirst(pending);
        used |= 1u << lane;
        const Triangle& triangle = all[numbers[lane]];
        int corner = -1;
        const auto other = std::find_if(pending.begin(), pending.end(), [&](std::uint32_t i) {
            return (corner = parallelogramCorner(triangle, all[i])) >= 0;
        });
        setEntry(lane, triangle, std::max(corner, 0));
        if (other == pending.end()) continue;
        numbers[lane + simd::lanes] = *other;
        used |= 1u << (lane + simd::lanes);
        pending.erase(other);
    }
}

void TrianglePacket::setEntry(std::size_t lane, const Triangle& triangle, int corner) {
    const Vec3& origin = triangle.vertices[corner];
    const Vec3 first = triangle.vertices[(corner + 1) % 3] - origin;
    const Vec3 second = triangle.vertices[(corner + 2) % 3] - origin;
    for (int i = 0; i < 3; ++i) {
        v0[i][lane] = origin[i];
        e1[i][lane] = first[i];
        e2[i][lane] = second[i];
    }
    extent[lane] = longestComponent(first, second);
}

// The first triangle is v + w <= 1; the second one is v + w >= 1, v <= 1 and w <= 1.
unsigned TrianglePacket::candidates(const FilterRay& ray) const {
    const PlaneHits hits(ray, loadRows(v0[0], simd::lanes), loadRows(e1[0], simd::lanes),
                         loadRows(e2[0], simd::lanes), load(extent));
    const Float sum = hits.v + hits.w;
    const Float error = hits.detError + 2 * hits.vwError;
    const Float most = hits.det + error;
    const Mask notFirst = hits.off | (sum > most);
    const Mask notSecond = hits.off | (hits.det - error > sum) | (hits.v > most) | (hits.w > most);
    const unsigned rejected = bits(hits.signKnown & notFirst) | bits(hits.signKnown & notSecond)
                                                                    << simd::lanes;
    return used & ~rejected;
}

}  // namespace sw
