#include "rayTree/rayMeasure.h"

#include <algorithm>
#include <cmath>

#include "swNumerics.h"

namespace rayTree {
namespace {

using namespace sw;

constexpr std::size_t none = static_cast<std::size_t>(-1);

// The sine of the angle between a ray and the direction to a light; 2 if the ray points away.
double angleTo(const Light& light, const Ray& ray) {
    const glm::dvec3 d = num::toDouble(ray.dir);
    const glm::dvec3 way = num::toDouble(light.position) - num::toDouble(ray.orig);
    if (!(dot(d, way) > 0)) return 2;
    return glm::length(cross(d, way)) / (glm::length(d) * glm::length(way));
}

bool isTaken(int light, const std::vector<RayNode>& others) {
    return std::any_of(others.begin(), others.end(),
                       [light](const RayNode& other) { return other.light == light; });
}

// Calls the function again for one node whose children are known, and answers from what is known.
class Replay {
public:
    Replay(const RayNode& parent, const Trace& function, Stage& onStage)
        : node(parent), trace(function), stage(onStage) {}

    // The colour that comes back if one traced child returns white and the others black.
    std::optional<Color> color(int light, std::size_t whiteChild = none) {
        std::size_t next = 0;
        whiteWasAsked = false;
        return stage.replay(trace, node.query.ray, node.depth, light,
                            [&](std::size_t number, const Ray& ray) {
                                if (number == 0) return Answer{&node.query};
                                const std::size_t child = find(ray, next);
                                if (child == none) return Answer{};
                                next = child + 1;
                                if (!node.children[child].isTraced)
                                    return Answer{&node.children[child].query};
                                whiteWasAsked |= child == whiteChild;
                                return Answer{nullptr, child == whiteChild};
                            });
    }

    bool whiteWasAsked = false;

private:
    // Children are cast in order, but without light some of them are not cast.
    std::size_t find(const Ray& ray, std::size_t from) const {
        for (std::size_t i = from; i < node.children.size(); ++i)
            if (isSame(ray, node.children[i].query.ray)) return i;
        return none;
    }

    const RayNode& node;
    const Trace& trace;
    Stage& stage;
};

}  // namespace

bool dependsOnNext(const RayNode& node, const Trace& trace, Stage& stage) {
    const auto colorWith = [&](bool white) {
        const auto answer = [&](std::size_t number, const Ray&) {
            if (number == 0) return Answer{&node.query};
            if (number > node.children.size())
                return Answer{nullptr, white && number == node.children.size() + 1};
            const RayNode& child = node.children[number - 1];
            return Answer{child.isTraced ? nullptr : &child.query};
        };
        return stage.replay(trace, node.query.ray, node.depth, allLights, answer);
    };
    const std::optional<Color> black = colorWith(false), white = colorWith(true);
    return black && white && !isSame(*black, *white);
}

void measure(RayNode& node, const Trace& trace, Stage& stage, bool lights) {
    const bool hasTraced = std::any_of(node.children.begin(), node.children.end(),
                                       [](const RayNode& child) { return child.isTraced; });
    if (!lights && !hasTraced) return;
    Replay replay(node, trace, stage);
    const Color rest = replay.color(noLight).value_or(Color());
    node.otherAdds = rest;
    node.lightAdds.clear();
    for (std::size_t i = 0; lights && i < stage.real.lights().size(); ++i)
        node.lightAdds.push_back(replay.color(static_cast<int>(i)).value_or(rest) - rest);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (!node.children[i].isTraced) continue;
        const std::optional<Color> color = replay.color(noLight, i);
        if (color && replay.whiteWasAsked) node.children[i].weight = *color - rest;
    }
}

int lightOf(const Ray& ray, const std::vector<Light>& lights, const std::vector<RayNode>& others) {
    int best = -1;
    for (const bool taken : {false, true}) {
        double bestAngle = 1e-3;  // students' own rays may start slightly off the surface
        for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
            const double angle = angleTo(lights[static_cast<std::size_t>(i)], ray);
            if (isTaken(i, others) != taken || !(angle < bestAngle)) continue;
            best = i;
            bestAngle = angle;
        }
        if (best >= 0) break;
    }
    return best;
}

}  // namespace rayTree
