#include "nff/nffShapes.h"

#include <cmath>

namespace sw {

// Triangulating a polygon takes quadratic time.
constexpr float mostVertices = 10000;

// Memory grows with the numbers read, not with the count that the file claims.
void NffShapes::readVertices(const char* keyword, bool withNormals, const char* hint) {
    float count;
    tokens.numbers({keyword, 1}, &count, 1);
    if (!(count >= 3 && count <= mostVertices && count == std::floor(count)))
        tokens.failAtLast("expected a number of vertices from 3 to 10000 (split larger polygons)");
    const int size = static_cast<int>(count) * (withNormals ? 6 : 3);
    vertices.clear();
    normals.clear();
    Vec3 v;
    for (int i = 0; i < size; i += 3) {
        tokens.numbers({keyword, size, hint}, v.m, 3, i);
        (withNormals && i % 2 == 1 ? normals : vertices).push_back(v);
    }
}

void NffShapes::warn(const char* statement, const std::string& what, const char* kind) {
    if (!warnAgain(kind)) oddities.push_back({kind, statement, what, 1});
}

bool NffShapes::warnAgain(const char* kind) {
    for (Oddity& oddity : oddities)
        if (oddity.kind == kind) return ++oddity.count > 0;
    return false;
}

std::vector<std::string> NffShapes::warnings() const {
    std::vector<std::string> lines;
    for (const Oddity& oddity : oddities)
        lines.push_back(tokens.place(oddity.first) + "warning: " + oddity.what + " (" +
                        std::string(oddity.kind) + std::to_string(oddity.count) + ")");
    return lines;
}

int NffShapes::lineOf(const char* statement) {
    line += countLineEnds(counted, statement);
    counted = statement;
    return line;
}

}  // namespace sw
