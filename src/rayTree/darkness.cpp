#include "rayTree/darkness.h"

#include <algorithm>

#include "nff/plainText.h"

namespace rayTree {
namespace {

using namespace sw;

bool isAsked(const RayNode& node, std::size_t light) {
    return std::any_of(node.children.begin(), node.children.end(), [=](const RayNode& child) {
        return child.light == static_cast<int>(light);
    });
}

void explainLights(const RayNode& node, const std::vector<Light>& lights,
                   std::vector<std::string>& reasons) {
    const Intersection& hit = node.query.hit;
    if (lights.empty()) reasons.push_back("no light in the scene, so nothing is scattered");
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i];
        const bool adds = i < node.lightAdds.size() && !node.lightAdds[i].isZero();
        if (adds || isAsked(node, i)) continue;
        const std::string name =
            "light " + std::to_string(i + 1) + " at " + plainText(light.position);
        if (light.color.isZero())
            reasons.push_back(name + " is black");
        else if (!(hit.normal * (light.position - hit.position) > 0))
            reasons.push_back(name + " is behind the surface");
    }
}

// depth 0 ends the recursion, whatever else the material would show.
void explainDepth(const RayNode& node, std::vector<std::string>& reasons) {
    const bool ends = std::none_of(node.children.begin(), node.children.end(),
                                   [](const RayNode& child) { return child.isTraced; });
    const Material& material = node.query.hit.material;
    if (node.depth > 0 || !ends) return;
    const auto explain = [&](float weight, const char* ray) {
        if (weight > 0)
            reasons.push_back("the depth is used up: no " + std::string(ray) + " ray of weight " +
                              plainText(weight) + " follows");
    };
    explain(material.reflectivity, "reflected");
    explain(material.transparency, "refracted");
}

}  // namespace

std::vector<std::string> darkReasons(const RayNode& node, const std::vector<Light>& lights) {
    std::vector<std::string> reasons;
    if (!node.isTraced || !node.query.isHit) return reasons;
    const Material& material = node.query.hit.material;
    if (1 - material.reflectivity - material.transparency > 0) {
        if (material.color.isZero())
            reasons.push_back(
                "the material scatters nothing: its colour (in the scene file: times Kd) is black");
        else
            explainLights(node, lights, reasons);
    }
    explainDepth(node, reasons);
    return reasons;
}

}  // namespace rayTree
