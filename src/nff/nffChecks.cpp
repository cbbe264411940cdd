#include "nff/nffChecks.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "nff/plainText.h"
#include "swNumerics.h"

namespace sw {
namespace {

// Whether every ray of the camera, at any width of the picture, leads away from the box: all of it
// lies behind the plane through the eye across the view, and not just by rounding.
bool isBehind(const Bounds& box, const NffView& view) {
    const glm::dvec3 eye = num::toDouble(view.from), forward = num::toDouble(view.at) - eye;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = ((corner >> axis & 1) != 0 ? box.max : box.min)[axis];
        const glm::dvec3 to = num::toDouble(p) - eye;
        if (!(dot(to, forward) < -1e-6 * length(to) * length(forward))) return false;
    }
    return true;
}

void warnOf(NffShapes& shapes, const char* at, const Color& color, const char* fault,
            const char* kind) {
    if (!shapes.warnAgain(kind)) shapes.warn(at, "colour " + plainText(color) + fault, kind);
}

void warnOfNegative(NffShapes& shapes, const char* at, const Color& color) {
    if (*std::min_element(color.m, color.m + 3) < 0)
        warnOf(shapes, at, color, " is negative", "used as it is; negative colours in this file: ");
}

}  // namespace

void warnOfColor(NffShapes& shapes, const char* at, const Color& color) {
    if (*std::max_element(color.m, color.m + 3) > 1)
        warnOf(shapes, at, color, " is beyond 1",
               "used as it is, though 1 is white, not 255; colours beyond 1 in this file: ");
    warnOfNegative(shapes, at, color);
}

void NffChecks::background(const char* at, const Color& color) {
    warnOfColor(shapes, at, color);
    isBackgroundBlack = color.isZero();
}

void NffChecks::light(const char* at, const Color& color) {
    warnOfNegative(shapes, at, color);  // brighter than 1 they may be, and often are
    if (!firstLight) firstLight = at;
    isAnyLightOn = isAnyLightOn || !color.isZero();
}

void NffChecks::material(const char* at, const Material& m) {
    const bool isDiffuse = 1 - m.reflectivity - m.transparency > 0 && !m.color.isZero();
    const bool isSpecular = m.reflectivity > 0 || m.transparency > 0;
    look = isDiffuse ? diffuse : isSpecular ? specular : black;
    materialAt = at;
}

void NffChecks::shape() {
    isUsed[look] = true;
    if (!firstUsed) firstUsed = materialAt;
    // Mostly the first shape can be seen, and the others' bounds need not be known.
    if (eye && shapes.bounds && shapes.bounds->isFinite() && !isAllBehind()) shapes.bounds.reset();
}

bool NffChecks::lacksLight() const {
    return isUsed[diffuse] && !isAnyLightOn;
}

bool NffChecks::isAllBehind() const {
    return shapes.bounds && shapes.bounds->isFinite() && isBehind(*shapes.bounds, *eye);
}

std::vector<std::string> NffChecks::warnings() const {
    std::vector<std::string> lines;
    const auto warn = [&](const char* at, const char* what) {
        lines.push_back(shapes.tokens.place(at) + "warning: " + what);
    };
    const char* const end = shapes.tokens.last().end();
    if (!firstUsed) warn(end, "no shape in the file: the picture shows its background alone");
    if (firstUsed && !isUsed[diffuse] && !isUsed[specular])
        warn(firstUsed, "every shape is black: Kd * colour, Ks and T of its material are 0");
    if (isUsed[specular] && !isUsed[diffuse] && isBackgroundBlack)
        warn(firstUsed,
             "no shape scatters light, and the background is black: the picture can only be black");
    if (lacksLight() && !firstLight) warn(end, "no light ('l') in the file: nothing is lit");
    if (lacksLight() && firstLight) warn(firstLight, "every light is black: nothing is lit");
    if (eye && isAllBehind())
        warn(eye->statement, "every shape is behind the camera: nothing is in view");
    return lines;
}

}  // namespace sw
