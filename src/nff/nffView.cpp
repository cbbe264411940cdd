#include "nff/nffView.h"

#include <cmath>

#include "swNumerics.h"

namespace sw {
namespace {

// Protects against files that ask for absurd amounts of work.
constexpr float largestSide = 16384;

bool areParallel(const Vec3& u, const Vec3& v) {
    return (Vec3(u).normalize() % Vec3(v).normalize()).norm() < 8 * num::unitRoundoff;
}

void expect(NffTokens& tokens, const char* keyword) {
    tokens.expectNoNumber();
    if (tokens.peek().text != keyword)
        tokens.failAtNext(std::string("expected '") + keyword + "' in the view");
    tokens.take();
}

Vec3 vectorAfter(NffTokens& tokens, const char* keyword) {
    expect(tokens, keyword);
    Vec3 v;
    tokens.numbers({keyword, 3}, v.m, 3);
    return v;
}

float numberAfter(NffTokens& tokens, const char* keyword) {
    expect(tokens, keyword);
    float value;
    tokens.numbers({keyword, 1}, &value, 1);
    return value;
}

int readSide(NffTokens& tokens, int before) {
    float side;
    tokens.numbers({"resolution", 2}, &side, 1, before);
    if (!(side >= 1 && side <= largestSide && side == std::floor(side)))
        tokens.failAtLast("expected a width and a height from 1 to 16384");
    return static_cast<int>(side);
}

}  // namespace

NffView readView(NffTokens& tokens) {
    const char* const statement = tokens.last().begin();
    NffView v;
    v.statement = statement;
    v.from = vectorAfter(tokens, "from");
    v.at = vectorAfter(tokens, "at");
    if ((v.at - v.from).isZero())
        tokens.fail(statement, "expected 'from' and 'at' to differ, found the same point");
    v.up = vectorAfter(tokens, "up");
    if (v.up.isZero() || areParallel(v.up, v.at - v.from))
        tokens.fail(statement,
                    "expected 'up' to point across the view, found it zero or along the view");
    v.angle = numberAfter(tokens, "angle");
    if (!(v.angle > 0 && v.angle < 180))
        tokens.failAtLast("expected an angle between 0 and 180 degrees");
    if (tokens.peek().text == "hither")  // a near clipping plane: ray tracing needs none
        numberAfter(tokens, "hither");
    if (tokens.peek().text != "resolution") return v;
    tokens.take();
    v.width = readSide(tokens, 0);
    v.height = readSide(tokens, 1);
    return v;
}

}  // namespace sw
