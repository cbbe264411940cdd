#include "tools/bench/room.h"

namespace bench {

using sw::Material;
using sw::Vec3;

std::vector<RoomTriangle> roomTriangles() {
    const Material white({0.9f, 0.9f, 0.9f}), red({1, 0.1f, 0.1f}), green({0.1f, 0.6f, 0.1f});
    std::vector<RoomTriangle> triangles;
    const auto wall = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                          const Material& material) {
        triangles.push_back({{a, b, c}, material});
        triangles.push_back({{a, c, d}, material});
    };
    wall({-20, 0, 50}, {20, 0, 50}, {20, 0, -50}, {-20, 0, -50}, white);
    wall({-20, 40, -50}, {20, 40, -50}, {20, 40, 50}, {-20, 40, 50}, white);
    wall({-20, 0, -50}, {20, 0, -50}, {20, 40, -50}, {-20, 40, -50}, white);
    wall({-20, 0, 50}, {-20, 0, -50}, {-20, 40, -50}, {-20, 40, 50}, red);
    wall({20, 0, -50}, {20, 0, 50}, {20, 40, 50}, {20, 40, -50}, green);
    return triangles;
}

std::vector<RoomSphere> roomSpheres() {
    const Material red({1, 0.1f, 0.1f}), green({0.1f, 0.6f, 0.1f}), blue({0, 0.2f, 0.9f});
    const Material mirror({1, 0.6f, 0.1f}, 0.2f), glass({1, 1, 1}, 0.2f, 0.8f, 1.3f);
    return {{{-7, 3, -20}, green}, {{0, 3, -20}, blue}, {{7, 3, -20}, red},  {{7, 3, 0}, mirror},
            {{9, 10, 0}, mirror},  {{-7, 3, 0}, glass}, {{-9, 10, 0}, glass}};
}

}  // namespace bench
