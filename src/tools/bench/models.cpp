#include "tools/bench/models.h"

#include <cmath>

#include "swCamera.h"
#include "swSampling.h"

namespace bench {
namespace {

using sw::Vec3;

constexpr double pi = 3.14159265358979323846;

float between(float low, float high) {
    return low + (high - low) * sw::uniform();
}

Vec3 inCube(float side) {
    const float x = between(-side, side), y = between(-side, side);
    return {x, y, between(-side, side)};
}

Vec3 direction() {
    for (;;) {
        const Vec3 v = inCube(1);
        if (v * v > 0.01f && v * v < 1) return Vec3(v).normalize();
    }
}

// Around the equator in 2n steps, from pole to pole in n.
Vec3 onBumpySphere(std::uint32_t i, std::uint32_t j, std::uint32_t n) {
    const double theta = pi * j / n, phi = pi * i / n;
    const double radius = 1 + 0.1 * std::sin(9 * theta) * std::sin(11 * phi);
    return {static_cast<float>(radius * std::sin(theta) * std::cos(phi)),
            static_cast<float>(radius * std::cos(theta)),
            static_cast<float>(radius * std::sin(theta) * std::sin(phi))};
}

// Six balls around the equator of their parent and three on its upper half.
std::array<Vec3, 9> flakeDirections(const Vec3& up) {
    const Vec3 other = std::fabs(up[0]) < 0.7f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = (up % other).normalize();
    const Vec3 v = up % u;
    std::array<Vec3, 9> result;
    for (std::size_t i = 0; i < 9; ++i) {
        const double angle =
            i < 6 ? static_cast<double>(i) * pi / 3 : pi / 6 + static_cast<double>(i) * 2 * pi / 3;
        const double height = i < 6 ? 0 : pi / 3;
        result[i] = std::cos(height) * std::cos(angle) * u +
                    std::cos(height) * std::sin(angle) * v + std::sin(height) * up;
    }
    return result;
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
    const float size = 1 / std::cbrt(static_cast<float>(count));
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 middle = inCube(0.7f);
        for (int k = 0; k < 3; ++k) model.vertices.push_back(middle + inCube(size));
        model.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return model;
}

Model sphereflake(std::uint32_t count) {
    Model model;
    model.name = "sphereflake";
    model.balls.push_back({{0, 0, 0}, 0.5f});
    std::vector<Vec3> ups{{0, 1, 0}};
    for (std::size_t parent = 0; model.balls.size() < count; ++parent) {
        const Model::Ball from = model.balls[parent];
        for (const Vec3& way : flakeDirections(ups[parent])) {
            const float radius = from.radius / 3;
            model.balls.push_back({from.center + (from.radius + radius) * way, radius});
            ups.push_back(Vec3(way).normalize());
        }
    }
    model.balls.resize(count);
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
        const Vec3 origin = 1.5f * direction();
        rays.emplace_back(origin, (inCube(0.6f) - origin).normalize());
    }
    return rays;
}

}  // namespace bench
