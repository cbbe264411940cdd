#include "app/explore/shapeColumns.h"

#include <bit>

#include "swCone.h"
#include "swPatch.h"
#include "swSphere.h"

namespace {

using namespace sw;

struct Described {
    std::uint32_t kind;
    std::vector<float> numbers;
};

std::vector<float> numbersOf(std::initializer_list<Vec3> points) {
    std::vector<float> numbers;
    for (const Vec3& point : points) numbers.insert(numbers.end(), point.m, point.m + 3);
    return numbers;
}

Described describe(const Primitive& shape) {
    Described result{0, {}};
    const auto triangle = [&](const Triangle& t) {
        return Described{1, numbersOf({t.vertices[0], t.vertices[1], t.vertices[2]})};
    };
    if (const auto* sphere = dynamic_cast<const Sphere*>(&shape)) {
        result.numbers = numbersOf({sphere->center});
        result.numbers.push_back(sphere->radius);
        return result;
    }
    if (const auto* plain = dynamic_cast<const Triangle*>(&shape)) return triangle(*plain);
    if (const auto* patch = dynamic_cast<const Patch*>(&shape)) return triangle(patch->triangle);
    if (const auto* cone = dynamic_cast<const Cone*>(&shape)) {
        result = {2, numbersOf({cone->base})};
        result.numbers.push_back(cone->baseRadius);
        for (const float number : cone->apex.m) result.numbers.push_back(number);
        result.numbers.push_back(cone->apexRadius);
        return result;
    }
    const Bounds box = shape.bounds();
    return {3, numbersOf({box.min, box.max})};
}

}  // namespace

ShapeColumns::ShapeColumns(const std::vector<NffShape>& shapes) {
    auto& [kind, line, material, geometry] = columns;
    for (const NffShape& shape : shapes) {
        const Described described = describe(*shape.primitive);
        kind.values.push_back(described.kind);
        line.values.push_back(static_cast<std::uint32_t>(shape.line));
        material.values.push_back(numberOf(shape.primitive->material));
        for (const float number : described.numbers)
            geometry.values.push_back(std::bit_cast<std::uint32_t>(number));
    }
}

// Shapes of one material stand together in the file.
std::uint32_t ShapeColumns::numberOf(const Material& m) {
    const auto isSame = [&](const Material& other) {
        return m.color[0] == other.color[0] && m.color[1] == other.color[1] &&
               m.color[2] == other.color[2] && m.reflectivity == other.reflectivity &&
               m.transparency == other.transparency && m.refractiveIndex == other.refractiveIndex;
    };
    if (materials.empty() || !isSame(materials.back())) materials.push_back(m);
    return static_cast<std::uint32_t>(materials.size() - 1);
}
