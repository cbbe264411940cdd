#include "nff/nffMaterial.h"

#include "nff/nffChecks.h"
#include "nff/nffSkipped.h"
#include "nff/plainText.h"

namespace sw {
namespace {

// As `f r g b Kd Ks Shine T i` spells it, without Shine.
struct FileMaterial {
    Color color;
    float kd, ks, t, index;

    bool isDiffuse() const { return kd > 0 && !color.isZero(); }
};

void refuseNonsense(const NffTokens& tokens, const char* statement, const FileMaterial& m) {
    if (m.kd < 0 || m.ks < 0 || m.t < 0)
        tokens.fail(statement, "expected Kd, Ks and T of 0 or more, found a negative one");
    if (m.t > 0 && !(m.index > 0))
        tokens.failAtLast("expected a positive index of refraction, as T is positive");
}

double sumOf(const FileMaterial& m) {
    return static_cast<double>(m.ks) + static_cast<double>(m.t);
}

void warnOf(NffShapes& shapes, const char* statement, const char* name, double value,
            const char* kind) {
    if (!shapes.warnAgain(kind))
        shapes.warn(statement, name + plainText(static_cast<float>(value)) + ", beyond 1", kind);
}

void warnOfRange(NffShapes& shapes, const char* statement, const FileMaterial& m) {
    constexpr double most = 1 + 1e-5;  // 0.6 + 0.4 is a little more than 1 in floats
    warnOfColor(shapes, statement, m.color);
    if (m.kd > 1)
        warnOf(shapes, statement, "Kd is ", static_cast<double>(m.kd),
               "used as it is; Kd beyond 1 in this file: ");
    if (sumOf(m) > most)
        warnOf(shapes, statement, "Ks + T is ", sumOf(m),
               "reduced to 1 where there is a diffuse part; Ks + T beyond 1 in this file: ");
}

// The format's diffuse part is Kd * color whatever Ks and T are; the shading's is 1 - r - t of the
// colour. So r and t leave a little, and the colour makes up for it.
Material toMaterial(FileMaterial m) {
    constexpr double most = 1 - 0x1p-12;  // seen by nobody: a 16th of an 8-bit step
    if (m.isDiffuse() && sumOf(m) > most) {
        const double factor = most / sumOf(m);
        for (float* part : {&m.ks, &m.t}) *part = static_cast<float>(*part * factor);
    }
    const float diffuse = 1 - m.ks - m.t;  // in the very steps of the shading
    const Color color = m.color * (diffuse > 0 ? m.kd / diffuse : m.kd);
    return Material(color, m.ks, m.t, m.t > 0 ? m.index : 1);
}

}  // namespace

Material readMaterial(NffShapes& shapes) {
    NffTokens& tokens = shapes.tokens;
    const char* const statement = tokens.last().begin();
    float v[8];
    tokens.numbers({"f", 8, "r g b Kd Ks Shine T index"}, v, 8);
    const FileMaterial material{Color(v[0], v[1], v[2]), v[3], v[4], v[6], v[7]};
    refuseNonsense(tokens, statement, material);
    warnOfRange(shapes, statement, material);
    skipTexture(shapes, statement);
    return toMaterial(material);
}

}  // namespace sw
