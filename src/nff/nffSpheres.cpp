#include "nff/nffReaders.h"
#include "nff/plainText.h"

namespace sw {

static std::string describe(const Primitive& shape) {
    const auto& sphere = static_cast<const Sphere&>(shape);
    return "centre " + plainText(sphere.center) + ", radius " + plainText(sphere.radius);
}

void readSphere(NffShapes& shapes, const Material& material) {
    NffTokens& tokens = shapes.tokens;
    const char* const statement = tokens.last().begin();
    float v[4];
    tokens.numbers({"s", 4, "x y z radius"}, v, 4);
    if (v[3] == 0) tokens.failAtLast("expected a radius other than 0");
    shapes.push(Sphere(Vec3(v[0], v[1], v[2]), v[3], material), statement, "sphere", describe);
}

}  // namespace sw
