#include "rayTree/rayTree.h"

#include <cmath>

#include "rayTree/rayFaults.h"
#include "rayTree/rayMeasure.h"

namespace rayTree {
namespace {

using namespace sw;

constexpr std::size_t mostNodesOfEndless = 24;

bool isWeight(const Color& c) {
    return !c.isZero() && std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]);
}

class Grower {
public:
    Grower(const Trace& function, const Scene& inScene) : trace(function), scene(inScene) {}

    RayTree grow(const Ray& primary, int depth) {
        const Run run = watch(trace, primary, scene, depth);
        recorded = run.queries;
        tree.ends = run.color.has_value();
        tree.cast = recorded.size();
        neverDecreases =
            watch(trace, primary, scene, 0).color && !watch(trace, primary, scene, 1).color;
        tree.primary.query.ray = primary;
        tree.primary.asked = !recorded.empty();
        follow(tree.primary, depth, run);
        tree.isFaithful = tree.isFaithful && (!tree.ends || place == recorded.size());
        tree.nodes = place;
        return std::move(tree);
    }

private:
    // Fills in a traced node and all nodes below it.
    void follow(RayNode& node, int depth, const Run& run) {
        node.depth = depth;
        node.color = run.color;
        if (run.queries.empty()) return;
        take(node, run.queries.front());
        while (const auto child = nextChild(node, trace, scene)) {
            node.isCut = !tree.ends && place >= mostNodesOfEndless;
            if (node.isCut) break;
            followChild(node, *child);
        }
        if (node.query.isHit) measure(node, trace, scene);
    }

    void followChild(RayNode& parent, const Offspring& child) {
        RayNode node;
        node.query.ray = child.ray;
        node.weight = child.weight;
        node.light = lightOf(child.ray, scene.lights(), parent.children);
        const Run lower = watch(trace, child.ray, scene, parent.depth - 1);
        const Run same = watch(trace, child.ray, scene, parent.depth);
        const bool isLower = !isSameDepth(lower, same);
        const Run& run = isLower ? lower : same;
        node.isTraced = isWeight(child.weight) || looksTraced(node, run);
        if (node.isTraced) {
            node.light = -1;
            follow(node, isLower ? parent.depth - 1 : parent.depth, run);
        } else {
            take(node, truth(child.ray));
        }
        parent.children.push_back(std::move(node));
    }

    // Whether the function forgot to decrease the depth: more rays followed than the lower depth
    // allows.
    bool isSameDepth(const Run& lower, const Run& same) const {
        if (!fits(same)) return false;
        if (!same.color && !lower.color) return neverDecreases;
        return !fits(lower) || same.queries.size() > lower.queries.size();
    }

    // Whether a ray of weight 0 was traced nevertheless. The rays that follow it tell; if none
    // could follow, its direction does.
    bool looksTraced(const RayNode& node, const Run& run) const {
        if (!fits(run)) return false;
        if (run.queries.size() > 1) return true;
        return node.query.ray.kind != RayKind::shadow && node.light < 0;
    }

    // Whether these rays are the next ones in the record.
    bool fits(const Run& run) const {
        for (std::size_t i = 0; i < run.queries.size(); ++i) {
            if (place + i >= recorded.size()) return !tree.ends;
            if (!isSame(run.queries[i].ray, recorded[place + i].ray)) return false;
        }
        return true;
    }

    Query truth(const Ray& ray) const {
        Query query;
        query.ray = ray;
        query.isHit = scene.intersect(ray, query.hit);
        return query;
    }

    void take(RayNode& node, const Query& query) {
        node.query = query;
        const bool isNext = place < recorded.size() && isSame(query.ray, recorded[place].ray);
        tree.isFaithful = tree.isFaithful && isNext;
        ++place;
    }

    const Trace& trace;
    const Scene& scene;
    std::vector<Query> recorded;  // of the real call
    bool neverDecreases = false;  // the depth, but ends at 0
    std::size_t place = 0;        // of the next ray in `recorded`
    RayTree tree;
};

}  // namespace

RayTree growTree(const Trace& trace, const Ray& primary, const Scene& scene, int depth) {
    RayTree tree = Grower(trace, scene).grow(primary, depth);
    markFaults(tree.primary);
    return tree;
}

}  // namespace rayTree
