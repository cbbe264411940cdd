#pragma once

// Triangles for a linear scan: with a dozen shapes that is faster than any tree.

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "accel/shapeBlocks.h"

namespace sw {
namespace {

// As a filter for parallelograms it tells of both triangles: the first one is v + w <= 1, the
// second one v + w >= 1, v <= 1 and w <= 1. The normal is exact but for its last rounding and 2^-50
// E^2. So a ray that starts next to the plane, as one that leaves it does, has the sign of n.g
// known.
class PairFilter : TriangleFilter {
public:
    PairFilter(const FilterRay& ray, const Float3& v0, const Float3& e1, const Float3& e2,
               const Float3& n, const Float& extent)
        : TriangleFilter(ray, v0 - spread(ray.orig), e1, e2, n, extent) {
        const Float x = n.x * g.x, y = n.y * g.y, z = n.z * g.z;
        t = flipSign(x + y + z, signedDet);
        tError =
            bound(8, abs(x) + abs(y) + abs(z)) + bound(0x1p-22f, largest(g) * (extent * extent));
    }

    unsigned missed() const {
        const Mask out = off();
        return both(signKnown & (out | (v + w > most())),
                    signKnown & (out | (least() > v + w) | (v > most()) | (w > most())));
    }
    unsigned hit() const {
        const Mask in = on();
        return both(in & (least() > v + w), in & (v + w > most()) & (least() > v) & (least() > w));
    }

private:
    static unsigned both(const Mask& first, const Mask& second) {
        return bits(first) | bits(second) << lanes;
    }
};

/// Up to eight triangles or parallelograms: pairs of triangles, as in walls and boxes.
class TrianglePacket {
public:
    /// Takes what fits in.
    /// @param pending  the triangles' numbers; what is taken is removed
    TrianglePacket(const std::vector<Triangle>& all, std::vector<std::uint32_t>& pending);

    /// The bits that there are: one for each triangle.
    unsigned bits() const { return used; }
    /// Which triangle a bit stands for.
    std::uint32_t number(std::uint32_t bit) const { return numbers[bit]; }
    SW_INLINE PairFilter filter(const FilterRay& ray) const {
        return {ray,
                loadRows(v0[0], lanes),
                loadRows(e1[0], lanes),
                loadRows(e2[0], lanes),
                loadRows(normal[0], lanes),
                load(extent)};
    }

private:
    void setEntry(std::size_t lane, const Triangle& triangle, int corner);

    float v0[3][lanes] = {}, e1[3][lanes] = {}, e2[3][lanes] = {}, normal[3][lanes] = {};
    float extent[lanes] = {};
    std::array<std::uint32_t, 2 * lanes> numbers{};  // first triangles, then second ones
    unsigned used = 0;
};

inline bool same(const Vec3& a, const Vec3& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// Two triangles make a parallelogram if they share an edge, and the corner across from it, mirrored
// at the edge's middle, is the other triangle's third vertex. Returns that corner, or -1.
inline int parallelogramCorner(const Triangle& triangle, const Triangle& other) {
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

inline TrianglePacket::TrianglePacket(const std::vector<Triangle>& all,
                                      std::vector<std::uint32_t>& pending) {
    for (std::size_t lane = 0; lane < lanes && !pending.empty(); ++lane) {
        const Triangle& triangle = all[pending.front()];
        numbers[lane] = pending.front();
        used |= 1u << lane;
        pending.erase(pending.begin());
        int corner = -1;
        const auto other = std::find_if(pending.begin(), pending.end(), [&](std::uint32_t i) {
            return (corner = parallelogramCorner(triangle, all[i])) >= 0;
        });
        setEntry(lane, triangle, std::max(corner, 0));
        if (other == pending.end()) continue;
        numbers[lane + lanes] = *other;
        used |= 1u << (lane + lanes);
        pending.erase(other);
    }
}

inline void TrianglePacket::setEntry(std::size_t lane, const Triangle& triangle, int corner) {
    const Vec3& origin = triangle.vertices[corner];
    const glm::dvec3 p = num::toDouble(origin);
    const glm::dvec3 first = num::toDouble(triangle.vertices[(corner + 1) % 3]) - p;
    const glm::dvec3 second = num::toDouble(triangle.vertices[(corner + 2) % 3]) - p;
    const Vec3 edge1 = num::toFloat(first), edge2 = num::toFloat(second);
    const Vec3 n = num::toFloat(cross(first, second));
    for (int i = 0; i < 3; ++i) {
        v0[i][lane] = origin[i];
        e1[i][lane] = edge1[i];
        e2[i][lane] = edge2[i];
        normal[i][lane] = n[i];
    }
    extent[lane] = longestComponent(edge1, edge2);
}

inline std::vector<TrianglePacket> packetsOf(const std::vector<Triangle>& triangles) {
    std::vector<TrianglePacket> packets;
    std::vector<std::uint32_t> pending(triangles.size());
    std::iota(pending.begin(), pending.end(), 0u);
    while (!pending.empty()) packets.emplace_back(triangles, pending);
    return packets;
}

}  // namespace
}  // namespace sw
