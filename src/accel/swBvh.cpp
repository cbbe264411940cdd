#include "swBvh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <tuple>

#include "accel/bvhBuild.h"
#include "accel/bvhOrder.h"
#include "accel/largePages.h"
#include "swThreads.h"

namespace sw {
namespace {

using namespace bvh;
using Node = Bvh::Node;

// From this depth on ranges are halved by number, which takes at most 10 levels: 8^10 > 2^28.
constexpr int depthOfHalving = Bvh::maxDepth - 10;

// The cost of entering a leaf; 1 is the cost of testing all its primitives at once.
constexpr float leafVisit = 0.25f;

// Subtrees of at most 1 / jobsPerTree of all primitives are built in parallel. Trees of fewer
// primitives than minParallel are built by one thread.
constexpr std::uint32_t jobsPerTree = 4, minParallel = 1u << 14;

// A subtree for another thread, and the parent's slot that its root goes into.
struct Job {
    Range range;
    int depth;
    std::uint32_t parent;
    int slot;
};

void setBox(Node& node, int slot, const Float& box) {
    // Beyond 2^126 a plane's distance to a ray's origin could overflow. Such planes move where the
    // box grows: outwards to infinity, or inwards to 2^126.
    constexpr float limit = 0x1p126f;
    float b[simd::lanes];
    std::memcpy(b, &box, sizeof b);
    for (int i = 0; i < 3; ++i) {
        const float low = -b[i], high = b[i + 4];
        node.planes[i][slot] = low < -limit ? -Bounds::infinity : std::min(low, limit);
        node.planes[i + 3][slot] = high > limit ? Bounds::infinity : std::max(high, -limit);
    }
}

// No ray meets these boxes. All the same, the children are leaves with a primitive that exists.
Node emptyNode() {
    Node node{};
    for (int i = 0; i < 6; ++i)
        std::fill_n(node.planes[i], Bvh::width, i < 3 ? Bounds::infinity : -Bounds::infinity);
    std::fill_n(node.child, Bvh::width, BvhNode::leaf(0, 1));
    return node;
}

class Builder {
public:
    // Where jobs is not null, ranges of at most jobLimit items become jobs.
    Builder(const SahSplitter& splitter, std::uint32_t jobLimit, std::vector<Job>* jobs)
        : splitter(splitter), jobLimit(jobLimit), jobs(jobs) {}

    std::vector<Node> nodes;

    void build(const Range& range, int depth) {
        nodes.emplace_back();
        fillNode(0, range, depth);
    }

private:
    struct Child {
        Range range;
        SahSplitter::Split split;
        float priority;  // the child with the highest is split next; negative: never
    };

    Child makeChild(const Range& range, int depth) const;
    int splitIntoChildren(const Range& range, int depth, std::array<Child, Bvh::width>& children);
    void fillNode(std::uint32_t index, const Range& range, int depth);

    const SahSplitter& splitter;
    std::uint32_t jobLimit;
    std::vector<Job>* jobs;
};

Builder::Child Builder::makeChild(const Range& range, int depth) const {
    Child child{range, {}, -1};
    if (range.count == 1) return child;
    const bool mustSplit = !splitter.isLeaf(range);
    if (depth >= depthOfHalving) {
        if (mustSplit) child.priority = static_cast<float>(range.count);
        return child;
    }
    const float area = splitter.area(range);
    const bool ofTwoKinds = mustSplit && range.count <= splitter.leafSize;
    if (!ofTwoKinds) child.split = splitter.findSplit(range);
    if (mustSplit || child.split.cost + leafVisit * area < area * splitter.cost(range.count))
        child.priority = area;
    return child;
}

int Builder::splitIntoChildren(const Range& range, int depth,
                               std::array<Child, Bvh::width>& children) {
    int n = 1;
    children[0] = makeChild(range, depth);
    const auto before = [](const Child& a, const Child& b) {
        return std::tie(a.priority, a.range.count) < std::tie(b.priority, b.range.count);
    };
    while (n < Bvh::width) {
        Child& widest = *std::max_element(children.begin(), children.begin() + n, before);
        if (widest.priority < 0) break;
        Range left, right;
        splitter.partition(widest.split, widest.range, left, right);
        widest = makeChild(left, depth);
        children[static_cast<std::size_t>(n++)] = makeChild(right, depth);
    }
    return n;
}

void Builder::fillNode(std::uint32_t index, const Range& range, int depth) {
    std::array<Child, Bvh::width> children;
    const int n = splitIntoChildren(range, depth, children);
    Node node = emptyNode();
    auto next = static_cast<std::uint32_t>(nodes.size());
    for (int i = 0; i < n; ++i) {
        const Range& r = children[static_cast<std::size_t>(i)].range;
        setBox(node, i, r.box);
        if (splitter.isLeaf(r))
            node.child[i] = BvhNode::leaf(r.first, r.count);
        else if (jobs && r.count <= jobLimit)
            jobs->push_back({r, depth + 1, index, i});
        else
            node.child[i] = next++;
    }
    bvh::setOrder(node);
    nodes[index] = node;
    nodes.resize(next);
    for (int i = 0; i < n; ++i)
        if (!BvhNode::isLeaf(node.child[i]))
            fillNode(node.child[i], children[static_cast<std::size_t>(i)].range, depth + 1);
}

std::vector<Item> makeItems(std::span<const Bounds> boxes, std::span<const std::uint32_t> kinds) {
    std::vector<Item> items(boxes.size());
    const auto lane = [](std::size_t i) {
        return std::bit_cast<float>(numberBit | static_cast<std::uint32_t>(i));
    };
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Bounds& b = boxes[i];
        items[i] = {{-b.min[0], -b.min[1], -b.min[2], lane(i), b.max[0], b.max[1], b.max[2],
                     lane(kinds.empty() ? 0 : kinds[i])}};
    }
    return items;
}

// Appends a subtree and links its root to its parent.
void append(std::vector<Node>& nodes, std::vector<Node>& subtree, const Job& job) {
    const auto offset = static_cast<std::uint32_t>(nodes.size());
    for (Node& node : subtree)
        for (std::uint32_t& child : node.child)
            if (!BvhNode::isLeaf(child)) child += offset;
    nodes[job.parent].child[job.slot] = offset;
    nodes.insert(nodes.end(), subtree.begin(), subtree.end());
    std::vector<Node>().swap(subtree);
}

// Calls work(i) for every i below n.
template <typename Work>
void inParallel(std::size_t n, int threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        for (std::size_t i = next++; i < n; i = next++) work(i);
    };
    onThreads(std::clamp(threads, 1, std::max(1, static_cast<int>(n))), run);
}

// The jobs depend on the primitives alone, so the tree is the same for any number of threads.
std::vector<Node> buildTree(SahSplitter& splitter, int threads) {
    const Range all = splitter.whole();
    std::vector<Job> jobs;
    Builder top(splitter, all.count / jobsPerTree, all.count < minParallel ? nullptr : &jobs);
    top.build(all, 0);
    std::vector<std::vector<Node>> subtrees(jobs.size());
    inParallel(jobs.size(), threads, [&](std::size_t i) {
        Builder builder(splitter, 0, nullptr);
        builder.build(jobs[i].range, jobs[i].depth);
        subtrees[i] = std::move(builder.nodes);
    });
    std::size_t count = top.nodes.size();
    for (const auto& subtree : subtrees) count += subtree.size();
    std::vector<Node> nodes;
    nodes.reserve(count);
    preferLargePages(nodes.data(), count * sizeof(Node));
    nodes.insert(nodes.end(), top.nodes.begin(), top.nodes.end());
    for (std::size_t i = 0; i < jobs.size(); ++i) append(nodes, subtrees[i], jobs[i]);
    return nodes;
}

}  // namespace

Bvh::Bvh(std::span<const Bounds> boxes, int leafSize, int threads,
         std::span<const std::uint32_t> kinds) {
    if (leafSize < 1 || leafSize > 8) throw std::invalid_argument("Bvh: leaf size not in 1..8");
    if (boxes.size() > 1u << BvhNode::sizeShift)
        throw std::length_error("Bvh: more than 2^28 boxes");
    if (boxes.empty()) return;
    std::vector<Item> items = makeItems(boxes, kinds);
    SahSplitter splitter(items, static_cast<std::uint32_t>(leafSize));
    nodes = buildTree(splitter, threads);
    primitives.reserve(items.size());
    for (const Item& item : items) primitives.push_back(item.number());
}

}  // namespace sw
