#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "swScene.h"

namespace test {

/// A closed surface of triangles around the origin, which lies inside.
struct Mesh {
    std::vector<sw::Vec3> vertices;
    std::vector<std::array<int, 3>> faces;

    const sw::Vec3& corner(std::size_t face, int i) const {
        return vertices[static_cast<std::size_t>(faces[face][static_cast<std::size_t>(i)])];
    }
};

inline sw::Scene toScene(const Mesh& mesh) {
    sw::Scene scene;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const sw::Vec3 v[] = {mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2)};
        scene.push(sw::Triangle(v, sw::Material()));
    }
    return scene;
}

inline Mesh tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
            {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

inline Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i & 1 ? 1.f : -1.f, i & 2 ? 1.f : -1.f, i & 4 ? 1.f : -1.f});
    mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

/// Cuts every face of a unit sphere's mesh into four.
inline Mesh refined(const Mesh& coarse) {
    Mesh fine;
    fine.vertices = coarse.vertices;
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [place, isNew] = middles.try_emplace(std::minmax(a, b));
        if (isNew) {
            place->second = static_cast<int>(fine.vertices.size());
            const auto vertex = [&](int i) { return coarse.vertices[static_cast<std::size_t>(i)]; };
            fine.vertices.push_back((vertex(a) + vertex(b)).normalize());
        }
        return place->second;
    };
    for (const auto& [a, b, c] : coarse.faces) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        fine.faces.insert(fine.faces.end(),
                          {{{a, ab, ca}}, {{b, bc, ab}}, {{c, ca, bc}}, {{ab, bc, ca}}});
    }
    return fine;
}

/// An icosahedron of 20 faces, refined `level` times.
inline Mesh icosphere(int level) {
    const float g = (1 + std::sqrt(5.0f)) / 2;
    Mesh mesh{{{-1, g, 0},
               {1, g, 0},
               {-1, -g, 0},
               {1, -g, 0},
               {0, -1, g},
               {0, 1, g},
               {0, -1, -g},
               {0, 1, -g},
               {g, 0, -1},
               {g, 0, 1},
               {-g, 0, -1},
               {-g, 0, 1}},
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (sw::Vec3& v : mesh.vertices) v.normalize();
    while (level-- > 0) mesh = refined(mesh);
    return mesh;
}

}  // namespace test
