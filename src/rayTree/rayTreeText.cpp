#include "rayTree/rayTreeText.h"

#include <algorithm>
#include <cmath>

#include "nff/plainText.h"
#include "rayTree/darkness.h"

namespace rayTree {
namespace {

using namespace sw;

// A single number if all channels are equal.
std::string weightText(const Color& w) {
    const bool grey = w[0] == w[1] && w[1] == w[2];
    return grey || (std::isnan(w[0]) && std::isnan(w[1]) && std::isnan(w[2])) ? plainText(w[0])
                                                                              : plainText(w);
}

bool isAbout(const Color& weight, float number) {
    const float allowed = 1e-5f * std::max(1e-3f, std::fabs(number));
    return std::all_of(weight.m, weight.m + 3,
                       [=](float w) { return std::fabs(w - number) <= allowed; });
}

const char* kindName(RayKind kind) {
    static constexpr const char* names[] = {"primary", "shadow", "reflected", "refracted", "other"};
    return names[static_cast<std::size_t>(kind)];
}

class Writer {
public:
    Writer(const Scene& inScene, const ShapeNames& shapeNames)
        : scene(inScene), names(shapeNames) {}

    // first, rest: prefix of the first line, and of all other lines
    void write(const RayNode& node, const RayNode* parent, const std::string& first,
               const std::string& rest) {
        const std::string below = rest + (node.children.empty() ? "   " : "|  ");
        const Ray& ray = node.query.ray;
        line(first, headline(node, parent));
        line(below, "from " + plainText(ray.orig) + " towards " + plainText(ray.dir) + range(ray));
        if (!node.asked)
            line(below, "never intersected with the scene");
        else if (node.isTraced || node.query.isHit)
            line(below, hitText(node.query));
        if (node.isTraced && node.query.isHit) writeOtherLight(node, below);
        for (const std::string& reason : darkReasons(node, scene.lights())) line(below, reason);
        for (const std::string& fault : node.faults) line(below, "!! " + fault);
        for (const std::string& name : names.hitNowhere(ray))
            line(below, "!! " + name + " claims a hit at t = NaN, which does not count");
        for (const RayNode& child : node.children) {
            const bool last = &child == &node.children.back();
            write(child, &node, rest + "+- ", rest + (last && !node.isCut ? "   " : "|  "));
        }
        if (node.isCut) line(rest, "+- ...");
    }

    std::string result;

private:
    void line(const std::string& indent, const std::string& content) {
        result += indent + content + "\n";
    }

    std::string headline(const RayNode& node, const RayNode* parent) const {
        const std::string kind = std::string(kindName(node.query.ray.kind)) + " ray";
        if (!node.isTraced) return kind + shadowText(node, *parent);
        std::string head = kind;
        if (parent) head += special(node, *parent) + ", weight " + weightText(node.weight);
        if (parent) head += disagreement(node, *parent);
        head += ", depth " + std::to_string(node.depth);
        return head + (node.color ? ": colour " + plainText(*node.color) : ": does not come back");
    }

    std::string shadowText(const RayNode& node, const RayNode& parent) const {
        const std::string state = node.query.isHit ? "blocked" : "lit";
        if (node.light < 0) return " towards no light: " + state;
        const auto i = static_cast<std::size_t>(node.light);
        std::string where = lightName(i) + ": " + state;
        if (i < parent.lightAdds.size()) where += ", adds " + plainText(parent.lightAdds[i]);
        return " to " + where;
    }

    std::string lightName(std::size_t i) const {
        return "light " + std::to_string(i + 1) + " at " + plainText(scene.lights()[i].position);
    }

    static std::string special(const RayNode& node, const RayNode& parent) {
        const Ray& ray = node.query.ray;
        const bool turnedBack =
            ray.kind == RayKind::refracted && ray.dir * parent.query.hit.normal > 0;
        return turnedBack ? " (total internal reflection)" : "";
    }

    // The material's weight, if the measured weight differs.
    static std::string disagreement(const RayNode& node, const RayNode& parent) {
        if (!parent.query.isHit) return "";
        const Material& material = parent.query.hit.material;
        const RayKind kind = node.query.ray.kind;
        const bool isReflectivity = isAbout(node.weight, material.reflectivity);
        const bool isTransparency = isAbout(node.weight, material.transparency);
        const std::string r = "reflectivity " + plainText(material.reflectivity);
        const std::string t = "transparency " + plainText(material.transparency);
        if (kind == RayKind::refracted)
            return isTransparency ? "" : " (the material says " + t + ")";
        if (isReflectivity || (isTransparency && kind != RayKind::reflected)) return "";
        if (kind != RayKind::reflected) return " (the material says " + r + ", " + t + ")";
        // getRefractedRay() may answer with getReflectedRay()
        if (isTransparency) return " (the transparency: total internal reflection?)";
        return " (the material says " + r + ")";
    }

    // Empty for the range from 0 to infinity.
    static std::string range(const Ray& ray) {
        std::string limits;
        if (ray.minT != 0) limits += ", from t = " + plainText(ray.minT);
        if (ray.maxT != FLT_MAX) limits += ", to t = " + plainText(ray.maxT);
        return limits;
    }

    std::string hitText(const Query& query) const {
        if (!query.isHit) return "hits nothing";
        const Intersection& hit = query.hit;
        return "hits " + names.hitBy(query.ray, hit) + (hit.frontFacing ? ", front" : ", back") +
               ", t = " + plainText(hit.hitT) + " at " + plainText(hit.position) + ", normal " +
               plainText(hit.normal);
    }

    // Parts of the colour that come without any ray.
    void writeOtherLight(const RayNode& node, const std::string& indent) {
        for (std::size_t i = 0; i < node.lightAdds.size(); ++i) {
            const bool asked = std::any_of(
                node.children.begin(), node.children.end(),
                [&](const RayNode& child) { return child.light == static_cast<int>(i); });
            if (!asked && !node.lightAdds[i].isZero())
                line(indent, lightName(i) + " adds " + plainText(node.lightAdds[i]) +
                                 " without a shadow ray");
        }
        if (!node.otherAdds.isZero())
            line(indent, "adds " + plainText(node.otherAdds) + " without light or ray");
    }

    const Scene& scene;
    const ShapeNames& names;
};

}  // namespace

std::string describe(const RayTree& tree, const Scene& scene, const ShapeNames& names) {
    Writer writer(scene, names);
    writer.write(tree.primary, nullptr, "", "");
    if (!tree.ends)
        writer.result += "!! stopped after " + std::to_string(tree.cast) +
                         " rays, of which these are the first: does the depth decrease in every "
                         "call, and does the recursion end at 0? If so, try a smaller --depth\n";
    else if (!tree.isFaithful)
        writer.result += "!! traceRay() cast " + std::to_string(tree.cast) +
                         " rays, but not exactly these: repeated calls behave differently\n";
    return writer.result;
}

}  // namespace rayTree
