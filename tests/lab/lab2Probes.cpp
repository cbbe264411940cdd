#include <cfloat>

#include "lab/triangleModels.h"

using namespace sw;

namespace lab {
namespace {

// Right-angled, acute and obtuse; with parallelograms larger and smaller than 1. None lies along
// an axis, where rounding decides what is in its box.
std::vector<Triangle> probedTriangles() {
    return {triangle({-1, -2, -1}, {3, -2, 2}, {-1, 3, -1}),
            triangle({1, -2, 3}, {5, -1, 4}, {3, 2, 1}),
            triangle({-0.5f, 1, 0.25f}, {0.5f, 1.25f, 0.25f}, {-1.25f, 1.5f, 0.5f})};
}

// Rays to that place, or away from it, that begin and end here and there. The numbers are odd, so
// that no mistake's t is minT or maxT by chance.
void addProbes(std::vector<Asked>& probes, const Triangle& shape, const Barycentric& place) {
    Vec3 n = normalOf(shape);
    n.normalize();
    for (const float height : {1.93f, -2.17f})
        for (const float slant : {0.f, 0.77f})
            for (const float t : {1.f, 0.53f, 3.7f, -0.9f}) {
                const Vec3 away = height * n + slant * (side(shape, 1) - 0.5f * side(shape, 2));
                const Vec3 dir = away * (-1 / t), orig = at(shape, place) + away;
                const auto add = [&](float minT, float maxT) {
                    probes.push_back({shape, Ray(orig, dir, minT, maxT), place, t});
                };
                add(0, FLT_MAX);
                if (t < 0) continue;
                add(0, 0.61f * t);
                add(0, 1.71f * t);
                add(0.57f * t, 1.83f * t);
                add(1.67f * t, 4.1f * t);
            }
}

}  // namespace

const std::vector<Asked>& probes() {
    static const float shares[] = {-2.311f, -1.273f, -0.618f, -0.171f, 0.093f,
                                   0.264f,  0.437f,  0.716f,  1.184f,  2.213f};
    static const std::vector<Asked> all = [] {
        std::vector<Asked> made;
        for (const Triangle& shape : probedTriangles())
            for (const float w : shares)
                for (const float v : shares) addProbes(made, shape, {w, 0.97f * v + 0.013f});
        return made;
    }();
    return all;
}

}  // namespace lab
