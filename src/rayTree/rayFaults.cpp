#include "rayTree/rayFaults.h"

#include <cmath>

namespace rayTree {
namespace {

using namespace sw;

bool isFinite(const Vec3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool hasNan(const Vec3& v) {
    return std::isnan(v[0]) || std::isnan(v[1]) || std::isnan(v[2]);
}

bool isNegative(const Vec3& v) {
    return v[0] < 0 || v[1] < 0 || v[2] < 0;
}

// Faults that were reported already: on the way down for the ray's start, on the way up for all
// rays below.
struct Wrong {
    bool number = false;    // NaN or infinite
    bool negative = false;  // colour
    bool depth = false;
};

void checkNumber(RayNode& node, Wrong& wrong, const char* where, const Vec3& v) {
    if (isFinite(v)) return;
    if (!wrong.number)
        node.faults.push_back(std::string(hasNan(v) ? "NaN" : "infinity") +
                              " first appears here, in " + where);
    wrong.number = true;
}

void checkDepth(RayNode& node, Wrong& wrong, int parentDepth) {
    const bool stays = node.depth >= parentDepth;
    if (!stays && node.depth >= 0) return;
    if (!wrong.depth)
        node.faults.push_back(stays ? "the depth did not decrease: it is still " +
                                          std::to_string(node.depth)
                                    : "the depth was used up already, and yet this ray was cast");
    wrong.depth = true;
}

void checkColor(RayNode& node, Wrong& wrong) {
    if (!node.isTraced || !node.color) return;
    checkNumber(node, wrong, "the colour", *node.color);
    if (!isNegative(*node.color)) return;
    if (!wrong.negative) node.faults.push_back("a negative colour first appears here");
    wrong.negative = true;
}

// above: the faults of the hit that the ray starts from
Wrong mark(RayNode& node, Wrong above, int parentDepth) {
    if (node.isTraced) checkDepth(node, above, parentDepth);
    checkNumber(node, above, "the ray's origin", node.query.ray.orig);
    checkNumber(node, above, "the ray's direction", node.query.ray.dir);
    if (node.query.isHit) {
        checkNumber(node, above, "the hit's position", node.query.hit.position);
        checkNumber(node, above, "the hit's normal", node.query.hit.normal);
    }
    Wrong below{.number = above.number};
    for (RayNode& child : node.children) {
        const Wrong wrong = mark(child, above, node.depth);
        below.number |= wrong.number;
        below.negative |= wrong.negative;
    }
    checkColor(node, below);
    return below;
}

}  // namespace

void markFaults(RayNode& primary) {
    mark(primary, {}, primary.depth + 1);
}

}  // namespace rayTree
