#include "app/explore/rayColumns.h"

#include <algorithm>
#include <bit>

#include "app/explore/quantise.h"

namespace {

using namespace sw;
using rayTree::RayNode;
using rayTree::RayTree;

// The columns. Those of a pixel's first rays change little from pixel to pixel: they are apart.
enum : std::size_t {
    head,
    light,
    share,
    x,
    y,
    z,
    weight,
    firstT,
    firstShape,
    firstU,
    firstV,
    firstRed,
    firstGreen,
    firstBlue,
    shape,
    u,
    v,
    red,
    green,
    blue
};
constexpr std::size_t ofFirst = firstShape, ofOthers = shape;  // the same numbers, side by side

enum : std::uint32_t { hit = 8, front = 16, traced = 32, hasChildren = 64, isLast = 128 };

std::uint32_t bitsOf(float number) {
    return std::bit_cast<std::uint32_t>(number);
}

float mean(const Color& c) {
    return (c[0] + c[1] + c[2]) / 3;
}

// Students' own rays may start a little off the surface: nobody sees a thousandth of the way there.
bool startsElsewhere(const RayNode& node, const RayNode& parent) {
    if (!parent.query.isHit) return true;
    const Vec3& place = parent.query.hit.position;
    const float way = (place - parent.query.ray.orig).norm();
    return !((node.query.ray.orig - place).norm() <= 1e-3f * way);
}

std::uint32_t headOf(const RayNode& node, bool last) {
    const auto bit = [](bool is, std::uint32_t value) { return is ? value : 0; };
    return static_cast<std::uint32_t>(node.query.ray.kind) | bit(node.query.isHit, hit) |
           bit(node.query.isHit && node.query.hit.frontFacing, front) | bit(node.isTraced, traced) |
           bit(!node.children.empty(), hasChildren) | bit(last, isLast);
}

// What a page says of the whole tree.
std::string faultOf(const RayTree& tree) {
    if (!tree.ends)
        return "does not end: stopped after " + std::to_string(tree.cast) +
               " rays, of which these are the first";
    return tree.isFaithful ? "" : "repeated calls behave differently: these rays are a guess";
}

}  // namespace

RayColumns::RayColumns()
    : columns{{{"head", 1, {}},       {"light", 1, {}},     {"share", 4, {}},  {"x", 3, {}},
               {"y", 3, {}},          {"z", 3, {}},         {"weight", 2, {}}, {"firstT", 4, {}},
               {"firstShape", 2, {}}, {"firstU", 2, {}},    {"firstV", 2, {}}, {"firstRed", 4, {}},
               {"firstGreen", 4, {}}, {"firstBlue", 4, {}}, {"shape", 2, {}},  {"u", 2, {}},
               {"v", 2, {}},          {"red", 2, {}},       {"green", 2, {}},  {"blue", 2, {}}}} {}

// Shape, normal and colour of a ray.
// first: the column of the shape; the others follow
void RayColumns::putSurface(const RayNode& node, const ShapeOf& shapeOf, std::size_t first) {
    if (node.query.isHit) put(first, shapeOf(node.query.ray, node.query.hit));
    if (!node.isTraced) return;
    if (node.query.isHit) {
        const OctDirection normal = octahedral(node.query.hit.normal);
        put(first + 1, normal.u);
        put(first + 2, normal.v);
    }
    const Color color = node.color.value_or(Color());
    for (std::size_t i = 0; i < 3; ++i)
        put(first + 3 + i, first == ofFirst ? bitsOf(color.m[i]) : float16(color.m[i]));
}

// Where a ray ends that is not its pixel's first.
void RayColumns::putPlace(const RayNode& node, const std::vector<Light>& lights) {
    const Ray& ray = node.query.ray;
    const bool hasLight = node.light >= 0 && node.light < 255;
    if (!node.isTraced) put(light, hasLight ? static_cast<std::uint32_t>(node.light) + 1 : 0);
    if (!node.isTraced && hasLight) {
        if (!node.query.isHit) return;
        const Vec3& end = lights[static_cast<std::size_t>(node.light)].position;
        put(share, bitsOf(node.query.hit.hitT * ray.dir.norm() / (end - ray.orig).norm()));
        return;
    }
    Vec3 place = node.query.hit.position;
    if (!node.query.isHit) place = ray.dir * (1 / ray.dir.norm());
    for (std::size_t i = 0; i < 3; ++i) put(x + i, float24(place.m[i]));
}

void RayColumns::putNode(const RayNode& node, const RayNode* parent,
                         const std::vector<Light>& lights, const ShapeOf& shapeOf,
                         std::uint32_t level) {
    for (const std::string& fault : node.faults) faults.push_back({rays, fault});
    if (!node.asked) faults.push_back({rays, "never intersected with the scene"});
    if (node.isTraced && !node.color) faults.push_back({rays, "does not come back"});
    if (node.isCut) faults.push_back({rays, "its further rays are left out"});
    put(head, headOf(node, !parent || &node == &parent->children.back()));
    deepest = std::max(deepest, level);
    if (!parent) {
        if (node.query.isHit) put(firstT, bitsOf(node.query.hit.hitT));
        putSurface(node, shapeOf, ofFirst);
    } else {
        if (startsElsewhere(node, *parent)) origins.push_back({rays, node.query.ray.orig});
        putPlace(node, lights);
        if (node.isTraced) put(weight, float16(mean(node.weight)));
        putSurface(node, shapeOf, ofOthers);
    }
    ++rays;
    for (const RayNode& child : node.children) putNode(child, &node, lights, shapeOf, level + 1);
}

void RayColumns::add(const RayTree& tree, const std::vector<Light>& lights,
                     const ShapeOf& shapeOf) {
    const std::string fault = faultOf(tree);
    if (!fault.empty()) faults.push_back({rays, fault});
    endless += !tree.ends;
    ++pixels;
    putNode(tree.primary, nullptr, lights, shapeOf, 0);
}

void RayColumns::append(const RayColumns& next) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::vector<std::uint32_t>& more = next.columns[i].values;
        columns[i].values.insert(columns[i].values.end(), more.begin(), more.end());
    }
    for (Origin origin : next.origins) origins.push_back({rays + origin.ray, origin.start});
    for (const Fault& fault : next.faults) faults.push_back({rays + fault.ray, fault.text});
    rays += next.rays;
    pixels += next.pixels;
    endless += next.endless;
    deepest = std::max(deepest, next.deepest);
}
