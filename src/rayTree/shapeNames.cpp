#include "rayTree/shapeNames.h"

#include <cmath>

#include "rayTree/rayProbe.h"

namespace rayTree {
namespace {

using namespace sw;

std::string describe(const NffShape& shape) {
    return std::string(shape.kind) + " (line " + std::to_string(shape.line) + ", " +
           (shape.describe ? shape.describe(*shape.primitive) : "of a kind unknown here") + ")";
}

bool isSameHit(const Intersection& a, const Intersection& b) {
    return isSame(a.position, b.position) && isSame(a.normal, b.normal) &&
           isSame(a.material.color, b.material.color);
}

}  // namespace

std::string ShapeNames::hitBy(const Ray& ray, const Intersection& hit) const {
    const NffShape* found = nullptr;
    for (const NffShape& shape : shapes) {
        Intersection candidate;
        if (!shape.primitive->intersect(ray, candidate) || candidate.hitT != hit.hitT) continue;
        if (isSameHit(candidate, hit)) return describe(shape);
        if (!found) found = &shape;  // unless another matches exactly
    }
    return found ? describe(*found) : "something that is not in the scene file";
}

std::vector<std::string> ShapeNames::hitNowhere(const Ray& ray) const {
    std::vector<std::string> names;
    for (const NffShape& shape : shapes) {
        Intersection candidate;
        if (shape.primitive->intersect(ray, candidate) && std::isnan(candidate.hitT))
            names.push_back(describe(shape));
    }
    return names;
}

}  // namespace rayTree
