#include "nff/nffShapes.h"

#include <algorithm>
#include <cmath>

namespace sw {

// Triangulating a polygon takes quadratic time.
constexpr float mostVertices = 10000;

// Memory grows with the numbers read, not with the count that the file claims.
void NffShapes::readVertices(const char* keyword, bool withNormals, const char* hint) {
    float count;
    tokens.numbers(keyword, &count, 1);
    if (!(count >= 3 && count <= mostVertices && count == std::floor(count)))
        tokens.failAtLast("expected a number of vertices from 3 to 10000 (split larger polygons)");
    const int size = static_cast<int>(count) * (withNormals ? 6 : 3);
    vertices.clear();
    normals.clear();
    Vec3 v;
    for (int i = 0; i < size; i += 3) {
        tokens.numbers({keyword, size, hint}, i, v.m, 3);
        (withNormals && i % 2 == 1 ? normals : vertices).push_back(v);
    }
}

void NffShapes::warn(const char* statement, const char* what, const char* kind) {
    const auto known = std::find_if(oddities.begin(), oddities.end(),
                                    [kind](const Oddity& o) { return o.kind == kind; });
    if (known != oddities.end())
        ++known->count;
    else
        oddities.push_back({kind, statement, what, 1});
}

std::vector<std::string> NffShapes::warnings() const {
    std::vector<std::string> lines;
    for (const Oddity& oddity : oddities)
        lines.push_back(tokens.place(oddity.first) + "warning: " + oddity.what + " (" +
                        std::string(oddity.kind) + std::to_string(oddity.count) + ")");
    return lines;
}

int NffShapes::lineOf(const char* statement) {
    line += static_cast<int>(std::count(counted, statement, '\n'));
    counted = statement;
    return line;
}

}  // namespace sw
