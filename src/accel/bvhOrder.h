#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "swBvhNode.h"

namespace sw::bvh {

/// How far along the directions of an octant the middle of a child's box lies. Empty boxes may come
/// out anywhere: no ray meets them.
inline float middleAlong(const BvhNode& node, int slot, unsigned octant) {
    constexpr float limit = 0x1p124f;  // sums stay finite
    float sum = 0;
    for (int i = 0; i < 3; ++i) {
        const float middle = std::clamp(node.planes[i][slot], -limit, limit) +
                             std::clamp(node.planes[i + 3][slot], -limit, limit);
        sum += (octant >> i & 1) != 0 ? -middle : middle;
    }
    return sum;
}

/// Fills in the order of a node's children for every octant. Opposite octants have opposite orders.
inline void setOrder(BvhNode& node) {
    for (unsigned octant = 0; octant < 4; ++octant) {
        std::array<std::pair<float, std::uint32_t>, BvhNode::width> children;
        for (std::uint32_t i = 0; i < BvhNode::width; ++i)
            children[i] = {middleAlong(node, static_cast<int>(i), octant), i};
        std::sort(children.begin(), children.end());
        for (int i = 0; i < BvhNode::width; ++i) {
            const std::uint32_t slot = children[static_cast<std::size_t>(i)].second;
            node.order[octant] |= slot << 3 * (BvhNode::width - 1 - i);
            node.order[7 - octant] |= slot << 3 * i;
        }
    }
}

}  // namespace sw::bvh
