#include "shapeNames.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace pixel {
namespace {

using namespace sw;

std::string corners(const Triangle& triangle) {
    const Vec3* v = triangle.vertices;
    return text(v[0]) + " " + text(v[1]) + " " + text(v[2]);
}

std::string describe(const NffShape& shape) {
    const Primitive* const p = shape.primitive.get();
    const auto name = [&](const char* kind, const std::string& what) {
        return std::string(kind) + " (line " + std::to_string(shape.line) + ", " + what + ")";
    };
    if (const auto* sphere = dynamic_cast<const Sphere*>(p))
        return name("sphere",
                    "centre " + text(sphere->center) + ", radius " + text(sphere->radius));
    if (const auto* triangle = dynamic_cast<const Triangle*>(p))
        return name("triangle", corners(*triangle));
    if (const auto* patch = dynamic_cast<const Patch*>(p))
        return name("patch", corners(patch->triangle));
    if (const auto* cone = dynamic_cast<const Cone*>(p))
        return name("cone", "base " + text(cone->base) + ", radius " + text(cone->baseRadius) +
                                ", apex " + text(cone->apex) + ", radius " +
                                text(cone->apexRadius));
    return name("other", "of a kind unknown here");
}

bool isSame(const Vec3& a, const Vec3& b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

bool isSame(const Intersection& a, const Intersection& b) {
    return isSame(a.position, b.position) && isSame(a.normal, b.normal) &&
           isSame(a.material.color, b.material.color);
}

}  // namespace

std::string ShapeNames::hitBy(const Ray& ray, const Intersection& hit) const {
    const NffShape* found = nullptr;
    for (const NffShape& shape : shapes) {
        Intersection candidate;
        if (!shape.primitive->intersect(ray, candidate) || candidate.hitT != hit.hitT) continue;
        if (isSame(candidate, hit)) return describe(shape);
        if (!found) found = &shape;  // unless one agrees in all
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

std::string text(float number) {
    if (std::isnan(number)) return "nan";  // whatever its sign
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << number + 0.0f;
    return stream.str();
}

std::string text(const Vec3& v) {
    std::string all("(");
    for (int i = 0; i < 3; ++i) all.append(text(v[i])).append(i < 2 ? ", " : ")");
    return all;
}

}  // namespace pixel
