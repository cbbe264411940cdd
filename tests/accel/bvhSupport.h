#pragma once

// Boxes and rays of every kind, and what a tree of them has to fulfil.

#include <algorithm>
#include <cfloat>
#include <limits>
#include <vector>

#include "accel/bvhTraversal.h"
#include "support.h"

namespace test {

using sw::Bounds;
using sw::Bvh;
using sw::Ray;

enum class Kind { scattered, flat, points, identical, hugeBesideTiny, line, nested, kinds };

inline Bounds randomBox(Random& random, Kind kind, float scale) {
    Vec3 centre = random.point(10), half = Vec3(1, 1, 1) + random.point(1);
    half *= random.magnitude(1e-3, 1);
    const int axis = random.whole(0, 2);
    if (kind == Kind::flat) half[axis] = 0;
    if (kind == Kind::points) half = Vec3();
    if (kind == Kind::identical) centre = half = Vec3(1, 2, 3);
    if (kind == Kind::hugeBesideTiny) half *= random.magnitude(1e-25, 1e6);
    if (kind == Kind::hugeBesideTiny) centre *= random.magnitude(1e-20, 1e6);
    if (kind == Kind::line) centre = Vec3(random.magnitude(1e-30, 1e6), 0, 0), half *= 1e-6f;
    if (kind == Kind::nested) centre = Vec3();
    return {(centre - half) * scale, (centre + half) * scale};
}

inline std::vector<Bounds> randomBoxes(Random& random, Kind kind, int n, float scale) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < n; ++i) boxes.push_back(randomBox(random, kind, scale));
    return boxes;
}

/// A ray near a box: at a corner, an edge, along a side, or anywhere; of any length and interval.
inline Ray randomRay(Random& random, const Bounds& box, float scale) {
    Vec3 target, orig = random.point(30) * scale;
    for (int i = 0; i < 3; ++i)
        target[i] = random.coin() ? (random.coin() ? box.min : box.max)[i]
                                  : random.real(box.min[i], box.max[i]);
    Vec3 dir = target - orig;
    if (!(dir.norm() > 0)) dir = random.direction();
    dir.normalize();
    for (int i = 0; i < 3; ++i) {
        const int special = random.whole(0, 11);
        if (special > 2) continue;
        dir[i] = special == 0 ? 0.0f : special == 1 ? -0.0f : 1e-40f;
        orig[i] = target[i];
    }
    if (!(dir.norm() > 0.1)) dir[random.whole(0, 2)] = random.coin() ? 1.0f : -1.0f;
    Ray ray(orig, dir);
    if (random.coin()) ray.dir *= random.magnitude(1e-20, 1e20);
    const float unit = 30 * scale / ray.dir.norm();
    if (random.whole(0, 3) == 0) ray.minT = unit * random.real(-2, 1);
    if (random.whole(0, 3) == 0) ray.maxT = ray.minT + unit * random.real(0, 2);
    if (random.whole(0, 7) == 0) ray.maxT = Bounds::infinity;
    return ray;
}

/// Whether the ray meets the box with minT < t < maxT: in double, whose errors are far smaller.
/// A t below -FLT_MAX is none.
inline bool meets(const Ray& ray, const Bounds& box) {
    double entry = -std::numeric_limits<double>::infinity(), exit = -entry;
    for (int i = 0; i < 3; ++i) {
        const double o = ray.orig[i], d = ray.dir[i];
        if (d == 0 && (o < box.min[i] || o > box.max[i])) return false;
        if (d == 0) continue;
        const double a = (box.min[i] - o) / d, b = (box.max[i] - o) / d;
        entry = std::max(entry, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return entry <= exit && exit > std::max(ray.minT, -FLT_MAX) && entry < ray.maxT;
}

/// Which primitives a traversal reaches if nothing is hit.
inline std::vector<int> reached(const Bvh& bvh, const Ray& ray) {
    std::vector<int> times(bvh.order().size());
    const auto leaf = [&](std::uint32_t first, std::uint32_t count, float&) {
        for (const auto i : bvh.order().subspan(first, count)) ++times[i];
        return false;
    };
    bvh.traverse(ray, leaf);
    return times;
}

inline bool encloses(const Bounds& outer, const Bounds& inner) {
    for (int i = 0; i < 3; ++i)
        if (!(outer.min[i] <= inner.min[i] && inner.max[i] <= outer.max[i])) return false;
    return true;
}

/// Walks through the tree and counts what is wrong with it.
struct Inspection {
    const Bvh& bvh;
    const std::vector<Bounds>& boxes;
    std::uint32_t leafSize;
    std::vector<int> times = std::vector<int>(boxes.size());
    int depth = 0, notEnclosed = 0, oversized = 0;

    void walk(std::uint32_t index, const Bounds& outer, int level) {
        depth = std::max(depth, level);
        const Bvh::Node& node = bvh.tree()[index];
        for (int i = 0; i < Bvh::width; ++i) {
            const auto& p = node.planes;
            const Bounds box({p[0][i], p[1][i], p[2][i]}, {p[3][i], p[4][i], p[5][i]});
            if (!(box.min[0] <= box.max[0])) continue;
            notEnclosed += !encloses(outer, box);
            if (sw::BvhNode::isLeaf(node.child[i]))
                inspectLeaf(node.child[i], box);
            else
                walk(node.child[i], box, level + 1);
        }
    }
    void inspectLeaf(std::uint32_t leaf, const Bounds& box) {
        oversized += sw::BvhNode::leafCount(leaf) > leafSize;
        for (const auto i :
             bvh.order().subspan(sw::BvhNode::leafFirst(leaf), sw::BvhNode::leafCount(leaf))) {
            ++times[i];
            notEnclosed += !encloses(box, boxes[i]);
        }
    }
};

inline void checkTree(const Bvh& bvh, const std::vector<Bounds>& boxes, int leafSize) {
    Inspection inspection{bvh, boxes, static_cast<std::uint32_t>(leafSize)};
    REQUIRE(bvh.order().size() == boxes.size());
    if (!boxes.empty()) inspection.walk(0, Bounds::unbounded(), 1);
    CHECK(std::count(inspection.times.begin(), inspection.times.end(), 1) ==
          static_cast<std::ptrdiff_t>(boxes.size()));
    CHECK(inspection.notEnclosed == 0);
    CHECK(inspection.oversized == 0);
    CHECK(inspection.depth <= Bvh::maxDepth);
}

/// Counts children that stand twice in the order of an octant, and those nearer than the next one.
inline void inspectOrder(const Bvh::Node& node, unsigned octant, int& twice, int& outOfOrder) {
    unsigned seen = 0;
    double before = HUGE_VAL;
    for (std::uint32_t order = node.order[octant], i = 0; i < 8; ++i, order >>= 3) {
        const auto slot = order & 7;
        twice += (seen >> slot & 1) != 0;
        seen |= 1u << slot;
        if (node.planes[0][slot] > node.planes[3][slot]) continue;  // empty
        double along = 0;                                           // in the octant's directions
        for (unsigned axis = 0; axis < 3; ++axis)
            along += ((octant >> axis & 1) != 0 ? -1.0 : 1.0) *
                     (node.planes[axis][slot] + node.planes[axis + 3][slot]);
        outOfOrder += along > before + 1e-5;
        before = along;
    }
}

inline Bvh::Cost costOfMiss(const Bvh& bvh, const Ray& ray) {
    return bvh.traverse(ray, [](std::uint32_t, std::uint32_t, float&) { return false; });
}

/// n x n boxes side by side, like a terrain.
inline std::vector<Bounds> terrain(int n) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < n * n; ++i) {
        const float size = 1 / static_cast<float>(n);
        const Vec3 low(static_cast<float>(i % n) * size, static_cast<float>(i / n) * size, 0);
        boxes.push_back({low, low + Vec3(size, size, size)});
    }
    return boxes;
}

}  // namespace test
