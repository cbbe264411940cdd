#include "rayTree/rayTree.h"

#include "rayTree/rayFaults.h"
#include "rayTree/rayMeasure.h"

namespace rayTree {
namespace {

using namespace sw;

constexpr std::size_t mostNodesOfEndless = 24;
constexpr std::size_t mostRaysInEndless = 200;  // below its first ray

// Whether the rays of `part` are the next ones of `whole` from a place on.
bool fits(const Run& part, const Run& whole, std::size_t place) {
    for (std::size_t i = 0; i < part.queries.size(); ++i) {
        if (place + i >= whole.queries.size()) return !whole.color;
        if (!isSame(part.queries[i].ray, whole.queries[place + i].ray)) return false;
    }
    return !part.queries.empty();
}

// Whether the ray at a place of a run starts where another hit, and not where its parent did.
bool startsAt(const Query& query, const Run& run, std::size_t place) {
    if (!query.isHit || place >= run.queries.size()) return false;
    const Vec3& start = run.queries[place].ray.orig;
    const float fromParent = (start - run.queries[0].hit.position).norm();
    return !(fromParent <= (start - query.hit.position).norm());
}

class Grower {
public:
    Grower(const Trace& function, Stage& onStage, bool measuresLights)
        : trace(function), stage(onStage), withLights(measuresLights) {}

    RayTree grow(const Ray& primary, int depth) {
        const Run run = stage.watch(trace, primary, depth);
        tree.ends = run.color.has_value();
        tree.cast = run.queries.size();
        if (!tree.ends) neverDecreases = watch(primary, 0).color && !watch(primary, 1).color;
        tree.primary.query.ray = primary;
        tree.primary.asked = !run.queries.empty();
        follow(tree.primary, depth, run);
        tree.isFaithful = tree.isFaithful && (!tree.ends || tree.nodes == tree.cast) &&
                          isRepeated(primary, depth, run);
        return std::move(tree);
    }

private:
    Run watch(const Ray& ray, int depth) {
        return stage.watch(trace, ray, depth, tree.ends ? mostRays : mostRaysInEndless);
    }

    // Fills in a traced node and all nodes below it, from the record of its own call.
    void follow(RayNode& node, int depth, const Run& run) {
        node.depth = depth;
        node.color = run.color;
        if (run.queries.empty()) return;
        node.query = run.queries.front();
        ++tree.nodes;
        for (std::size_t place = 1; place < run.queries.size();) {
            node.isCut = !tree.ends && tree.nodes >= mostNodesOfEndless;
            if (node.isCut) break;
            place += followChild(node, run, place);
        }
        if (node.query.isHit) measure(node, trace, stage, withLights);
    }

    // Returns how many rays of the parent's call are the child's.
    std::size_t followChild(RayNode& parent, const Run& run, std::size_t place) {
        RayNode node;
        node.query = run.queries[place];
        node.light = lightOf(node.query.ray, stage.real.lights(), parent.children);
        // Nothing follows a shadow ray: that saves asking what tracing it would do.
        const bool isShadow =
            node.query.ray.kind == RayKind::shadow && !startsAt(node.query, run, place + 1);
        int depth = parent.depth - 1;
        Run own;
        if (!isShadow) own = findCall(node.query.ray, depth, run, place);
        const bool isFound = fits(own, run, place);
        node.isTraced = (isFound && (own.queries.size() > 1 || node.light < 0)) ||
                        (!isShadow && dependsOnNext(parent, trace, stage));
        if (node.isTraced) {
            node.light = -1;
            tree.isFaithful &= isFound;
            follow(node, depth, own);
        } else {
            ++tree.nodes;
        }
        parent.children.push_back(std::move(node));
        return isFound ? own.queries.size() : 1;
    }

    // The call that cast the ray at a place of its parent's run. Its depth is one less, unless the
    // function forgot to decrease it: then more rays followed than the lower depth allows.
    // depth: one less; receives the true one
    Run findCall(const Ray& ray, int& depth, const Run& run, std::size_t place) {
        Run lower = watch(ray, depth);
        const bool fitsLower = fits(lower, run, place);
        if (fitsLower && lower.color && endsBefore(place + lower.queries.size(), lower, run))
            return lower;
        Run same = watch(ray, depth + 1);
        if (!fits(same, run, place)) return lower;
        const bool isSameDepth = !same.color && !lower.color
                                     ? neverDecreases
                                     : !fitsLower || same.queries.size() > lower.queries.size();
        depth += isSameDepth;
        return isSameDepth ? same : lower;
    }

    // Whether what follows a call does not start from any of its hits.
    static bool endsBefore(std::size_t next, const Run& call, const Run& run) {
        for (const Query& query : call.queries)
            if (startsAt(query, run, next)) return false;
        return true;
    }

    // Whether the function casts the same rays again, if it is told the same.
    bool isRepeated(const Ray& primary, int depth, const Run& run) {
        std::size_t same = 0, all = 0;
        stage.replay(trace, primary, depth, allLights, [&](std::size_t number, const Ray& ray) {
            ++all;
            if (number >= run.queries.size()) return Answer{};
            same += isSame(ray, run.queries[number].ray);
            return Answer{&run.queries[number]};
        });
        return same == run.queries.size() && (!tree.ends || all == same);
    }

    const Trace& trace;
    Stage& stage;
    const bool withLights;
    bool neverDecreases = false;  // the depth, but ends at 0
    RayTree tree;
};

}  // namespace

RayTree growTree(const Trace& trace, const Ray& primary, Stage& stage, int depth, bool lights) {
    RayTree tree = Grower(trace, stage, lights).grow(primary, depth);
    markFaults(tree.primary);
    return tree;
}

}  // namespace rayTree
