#pragma once

#include "rayTree/rayTree.h"
#include "student.h"

// Scenes and rays for students' functions, and the trees of rays that come of them.

namespace test {

using sw::Intersection;
using sw::Light;
using sw::Material;
using sw::Ray;
using sw::Scene;
using sw::Sphere;

inline Material randomMaterial(Random& random) {
    const Color color(random.real(0.1, 1), random.real(0.1, 1), random.real(0.1, 1));
    const float r = random.coin() ? random.real(0.05, 0.5) : 0.f;
    const float t = random.coin() ? random.real(0.05, 0.5) : 0.f;
    return Material(color, r, t, random.real(1, 2));
}

/// Some spheres around the origin, some lights and a sky.
inline Scene randomRoom(Random& random) {
    Scene scene;
    for (int i = random.whole(2, 12); i > 0; --i)
        scene.push(Sphere(random.point(6), random.real(0.5, 4), randomMaterial(random)));
    for (int i = random.whole(0, 4); i > 0; --i)
        scene.push(Light(random.point(20), Color(random.real(0.1, 1), random.real(0.1, 1), 1)));
    scene.setBackground(Color(0.25f, random.real(0, 1), 0.75f));
    return scene;
}

/// From outside into the middle.
inline Ray randomLook(Random& random) {
    const Vec3 eye = 30 * random.direction();
    return Ray(eye, (random.point(3) - eye).normalize(), 0, FLT_MAX, sw::RayKind::primary);
}

/// Calls visit(node, parent) for every node, parents first; the first has none.
template <typename Visit>
void visitAll(const rayTree::RayNode& node, const Visit& visit,
              const rayTree::RayNode* parent = nullptr) {
    visit(node, parent);
    for (const rayTree::RayNode& child : node.children) visitAll(child, visit, &node);
}

}  // namespace test
