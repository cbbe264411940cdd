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

// Calls the function again for one node whose children are known.
class Replay {
public:
    Replay(const RayNode& parent, const Trace& function, const Scene& inScene)
        : node(parent), trace(function), scene(inScene), lights(inScene.lights()) {
        for (Light& light : lights) light.color = Color(0, 0, 0);
    }

    void turnOn(std::size_t light) { lights[light].color = scene.lights()[light].color; }
    void turnOff(std::size_t light) { lights[light].color = Color(0, 0, 0); }

    // The colour that comes back if one traced child returns white and the others black.
    std::optional<Color> colorWith(std::size_t whiteChild) {
        std::size_t next = 0;
        whiteWasAsked = false;
        const auto answer = [&](std::size_t number, const Ray& ray) {
            if (number == 0) return Answer::truth;
            const std::size_t child = find(ray, next);
            if (child == none) return Answer::nothing;
            next = child + 1;
            if (!node.children[child].isTraced) return Answer::truth;
            if (child != whiteChild) return Answer::nothing;
            whiteWasAsked = true;
            return Answer::whiteNothing;
        };
        return replay(trace, node.query.ray, scene, node.depth, lights, answer).color;
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
    const Scene& scene;
    std::vector<Light> lights;
};

}  // namespace

std::optional<Offspring> nextChild(const RayNode& node, const Trace& trace, const Scene& scene) {
    const std::size_t sought = node.children.size() + 1;
    const auto runWith = [&](Answer atSought) {
        const auto answer = [&](std::size_t number, const Ray&) {
            if (number == 0) return Answer::truth;
            if (number == sought) return atSought;
            if (number > sought || node.children[number - 1].isTraced) return Answer::nothing;
            return Answer::truth;
        };
        return replay(trace, node.query.ray, scene, node.depth, scene.lights(), answer);
    };
    const Run black = runWith(Answer::nothing);
    if (black.queries.size() <= sought) return std::nullopt;
    const Run white = runWith(Answer::whiteNothing);
    const Color unknown(NAN, NAN, NAN);
    return Offspring{black.queries[sought].ray,
                     black.color && white.color ? *white.color - *black.color : unknown};
}

void measure(RayNode& node, const Trace& trace, const Scene& scene) {
    Replay dark(node, trace, scene);
    const Color rest = dark.colorWith(none).value_or(Color());
    node.otherAdds = rest;
    node.lightAdds.clear();
    for (std::size_t i = 0; i < scene.lights().size(); ++i) {
        dark.turnOn(i);
        node.lightAdds.push_back(dark.colorWith(none).value_or(rest) - rest);
        dark.turnOff(i);
    }
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (!node.children[i].isTraced) continue;
        const std::optional<Color> color = dark.colorWith(i);
        if (color && dark.whiteWasAsked) node.children[i].weight = *color - rest;
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
