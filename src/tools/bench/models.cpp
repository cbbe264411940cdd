#include "tools/bench/models.h"

#include <cmath>

#include "swCamera.h"
#include "tools/common/random.h"
#include "tools/common/sphereflake.h"

namespace bench {
namespace {

using report::direction;
using report::inCube;
using sw::Vec3;
using sw::num::toFloat;

constexpr double pi = 3.14159265358979323846;

// Around the equator in 2n steps, from pole to pole in n.
Vec3 onBumpySphere(std::uint32_t i, std::uint32_t j, std::uint32_t n) {
    const double theta = pi * j / n, phi = pi * i / n;
    const double radius = 1 + 0.1 * std::sin(9 * theta) * std::sin(11 * phi);
    return {static_cast<float>(radius * std::sin(theta) * std::cos(phi)),
            static_cast<float>(radius * std::cos(theta)),
            static_cast<float>(radius * std::sin(theta) * std::sin(phi))};
}

}  // namespace

sw::Triangle Model::triangle(std::size_t i) const {
    const auto& t = triangles[i];
    const Vec3 v[] = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    return sw::Triangle(v, {});
}

Model bumpySphere(std::uint32_t n) {
    Model model;
    model.name = "bumpy sphere";
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i < 2 * n; ++i) model.vertices.push_back(onBumpySphere(i, j, n));
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < 2 * n; ++i) {
            const std::uint32_t a = 2 * n * j + i, b = 2 * n * j + (i + 1) % (2 * n);
            model.triangles.push_back({a, b, a + 2 * n});
            model.triangles.push_back({b, b + 2 * n, a + 2 * n});
        }
    }
    return model;
}

Model triangleSoup(std::uint32_t count) {
    sw::seedPixel(1, 0, 0);
    Model model;
    model.name = "soup";
    const double size = 1 / std::cbrt(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 middle = inCube(0.7);
        for (int k = 0; k < 3; ++k) model.vertices.push_back(toFloat(middle + inCube(size)));
        model.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return model;
}

Model sphereflake(std::uint32_t count) {
    Model model;
    model.name = "sphereflake";
    for (const scenes::Ball& ball : scenes::sphereflake(count, {0, 1, 0}))
        model.balls.push_back({toFloat(ball.center), static_cast<float>(ball.radius)});
    return model;
}

sw::Scene sceneOf(const Model& model) {
    sw::Scene scene;
    for (std::size_t i = 0; i < model.triangles.size(); ++i) scene.push(model.triangle(i));
    for (const Model::Ball& ball : model.balls)
        scene.push(sw::Sphere(ball.center, ball.radius, {}));
    return scene;
}

std::vector<sw::Ray> primaryRays(int size) {
    constexpr int tile = 16;
    sw::Camera camera({1, 1.5f, 2.5f}, {0, 0, 0}, {0, 1, 0}, 40);
    camera.setup(size, size);
    std::vector<sw::Ray> rays;
    for (int top = 0; top < size; top += tile)
        for (int left = 0; left < size; left += tile)
            for (int i = 0; i < tile * tile; ++i)
                rays.push_back(camera.getRay(static_cast<float>(left + i % tile) + 0.5f,
                                             static_cast<float>(top + i / tile) + 0.5f));
    return rays;
}

std::vector<sw::Ray> randomRays(int count) {
    sw::seedPixel(2, 0, 0);
    std::vector<sw::Ray> rays;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 origin = 1.5 * direction();
        rays.emplace_back(toFloat(origin), toFloat(normalize(inCube(0.6) - origin)));
    }
    return rays;
}

}  // namespace bench
