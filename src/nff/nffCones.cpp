#include "nff/nffReaders.h"
#include "nff/plainText.h"
#include "swCone.h"

namespace sw {
namespace {

bool haveOppositeSigns(float a, float b) {
    return (a < 0 && b > 0) || (a > 0 && b < 0);
}

std::string describe(const Primitive& shape) {
    const auto& cone = static_cast<const Cone&>(shape);
    return "base " + plainText(cone.base) + ", radius " + plainText(cone.baseRadius) + ", apex " +
           plainText(cone.apex) + ", radius " + plainText(cone.apexRadius);
}

}  // namespace

void readCone(NffShapes& shapes, const Material& material) {
    NffTokens& tokens = shapes.tokens;
    const char* const statement = tokens.last().begin();
    float v[8];
    tokens.numbers({"c", 8, "base and apex, each a point and a radius"}, v, 8);
    const Vec3 base(v[0], v[1], v[2]), apex(v[4], v[5], v[6]);
    const float baseRadius = v[3], apexRadius = v[7];
    if (haveOppositeSigns(baseRadius, apexRadius))
        tokens.failAtLast("expected two radii of the same sign");
    if (baseRadius == 0 && apexRadius == 0)
        tokens.failAtLast("expected a radius other than 0 at one end at least");
    // Some exporters write caps as cones without height, and others thin cones in too few digits.
    if ((apex - base).isZero())
        return shapes.warn(statement, "cone has no height",
                           "left out; cones without height in this file: ");
    shapes.push(Cone(base, baseRadius, apex, apexRadius, material), statement, "cone", describe);
}

}  // namespace sw
