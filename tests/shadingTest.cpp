#include "support.h"
#include "swRayCount.h"
#include "testScenes.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

const double pi = std::acos(-1.0);
const Ray downwards(Vec3(0, 0, 10), Vec3(0, 0, -1));

// Falls at 45 degrees onto the origin.
const Ray slanted(Vec3(-5, 0, 5), Vec3(1, 0, -1));

const Material white(Color(1, 1, 1));

// A floor z = 0 under a light.
Scene litFloor(const Material& material, const Light& light) {
    Scene scene;
    scene.push(tile(0, material));
    scene.push(light);
    return scene;
}

// What traceRay returns, and the rays it took.
struct Traced {
    Color color;
    RayCount count;
};
Traced trace(const Ray& ray, const Scene& scene, int depth) {
    takeRayCount();
    const Color color = lab::traceRay(ray, scene, depth);
    return {color, takeRayCount()};
}

// A plane that casts no shadow, not even on itself.
class Ghost : public Plane {
public:
    using Plane::Plane;
    bool intersect(const Ray& ray, Intersection& hit) const override {
        return ray.kind != RayKind::shadow && Plane::intersect(ray, hit);
    }
};

}  // namespace

TEST_CASE("a ray that hits nothing brings back the background") {
    Scene scene;
    CHECK(distance(lab::traceRay(downwards, scene, 3), Vec3(0, 0, 0)) == 0);
    scene.setBackground(Color(0.25f, 0.5f, 2));
    CHECK(distance(lab::traceRay(downwards, scene, 3), Vec3(0.25f, 0.5f, 2)) == 0);
    CHECK(distance(lab::traceRay(downwards, scene, 0), Vec3(0.25f, 0.5f, 2)) == 0);
    scene.push(tile(0, white));
    CHECK(distance(lab::traceRay(downwards, scene, 3), Vec3(0, 0, 0)) == 0);  // unlit
}

TEST_CASE("scattered light follows Lambert's cosine") {
    const int degrees = GENERATE(0, 1, 15, 30, 45, 60, 75, 85, 89);
    Random random(static_cast<unsigned>(degrees));
    for (int i = 0; i < 50; ++i) {
        const double angle = degrees * pi / 180, around = random.uniform(0, 2 * pi);
        const double far = random.magnitude(0.1, 1000);  // no fall-off
        const dvec3 light = far * dvec3(std::sin(angle) * std::cos(around),
                                        std::sin(angle) * std::sin(around), std::cos(angle));
        const Scene scene = litFloor(white, Light(num::toFloat(light)));
        const Vec3 eye(random.real(-5, 5), random.real(-5, 5), random.real(1, 5));
        CAPTURE(degrees, around, far, eye);
        const Color color = lab::traceRay(Ray(eye, -eye), scene, 3);  // whoever looks at the origin
        CHECK(distance(color, std::cos(angle) * dvec3(1)) < 4e-6);
    }
}

TEST_CASE("light behind the surface gives nothing") {
    const int degrees = GENERATE(90, 91, 120, 150, 180, 240, 270);
    const double angle = degrees * pi / 180;
    const Vec3 light = degrees == 90 ? Vec3(5, 0, 0)
                                     : Vec3(static_cast<float>(5 * std::sin(angle)), 0,
                                            static_cast<float>(5 * std::cos(angle)));
    CAPTURE(degrees);
    const auto solid = trace(slanted, litFloor(white, Light(light)), 3);
    CHECK(distance(solid.color, Vec3(0, 0, 0)) == 0);
    // The same for a surface that would let light through: no term is negative.
    Scene ghostly;
    ghostly.push(std::make_shared<Ghost>(0.f, white));
    ghostly.push(Light(light));
    CHECK(distance(lab::traceRay(slanted, ghostly, 3), Vec3(0, 0, 0)) == 0);
}

TEST_CASE("the side that is seen is the side that is lit") {
    Scene scene = litFloor(white, Light(Vec3(0, 0, -8)));
    CHECK(distance(lab::traceRay(downwards, scene, 3), Vec3(0, 0, 0)) == 0);
    CHECK(distance(lab::traceRay(Ray(Vec3(0, 0, -9), Vec3(0, 0, 1)), scene, 3), white.color) <
          1e-6);
    Scene inside;
    inside.push(Sphere(Vec3(0, 0, 0), 5, white));
    inside.push(Light(Vec3(0, 0, 1)));
    CHECK(distance(lab::traceRay(Ray(Vec3(0, 0, 0), Vec3(0, 0, -1)), inside, 3), white.color) <
          1e-6);
    CHECK(distance(lab::traceRay(downwards, inside, 3), Vec3(0, 0, 0)) == 0);
}

TEST_CASE("coloured lights add up on a coloured surface") {
    Random random(GENERATE(range(0u, 100u)));
    const auto tint = [&] {
        return Color(random.real(0, 1), random.real(0, 1), random.real(0, 1));
    };
    const Color paint = tint();
    Scene scene;
    scene.push(tile(0, Material(paint)));
    dvec3 expected(0);
    const int lights = random.whole(1, 7);
    for (int i = 0; i < lights; ++i) {
        const Light light(random.direction() * random.magnitude(0.5, 50), tint());
        const double cosine = toDouble(light.position).z / glm::length(toDouble(light.position));
        scene.push(light);
        expected += std::max(0.0, cosine) * toDouble(paint) * toDouble(light.color);
    }
    CHECK(distance(lab::traceRay(slanted, scene, 0), expected) < 1e-5);
}

TEST_CASE("only objects between point and light cast a shadow") {
    const float z = GENERATE(-3.f, 2.f, 4.f, 8.f, 20.f);
    Scene scene = litFloor(white, Light(Vec3(3, 0, 6)));
    scene.push(Sphere(Vec3(z / 2, 0, z), 0.5f, white));
    const bool between = z > 0 && z < 6;
    const Ray ray(Vec3(-3, 0, 3), Vec3(1, 0, -1));
    const double cosine = between ? 0 : 6 / std::sqrt(45.0);
    CAPTURE(z);
    CHECK(distance(lab::traceRay(ray, scene, 3), dvec3(cosine)) < 1e-6);
}

TEST_CASE("a shadowed mirror still reflects") {
    const Color sky(0.25f, 0.5f, 1);
    Scene scene = litFloor(Material(Color(1, 0, 0), 0.75f), Light(Vec3(0, 0, 8)));
    scene.setBackground(sky);
    CHECK(distance(lab::traceRay(slanted, scene, 1), Color(0.25f, 0, 0) + 0.75f * sky) < 1e-6);
    scene.push(Sphere(Vec3(0, 0, 4), 1, white));
    CHECK(distance(lab::traceRay(slanted, scene, 1), 0.75f * sky) < 1e-6);
    CHECK(distance(lab::traceRay(slanted, scene, 0), Vec3(0, 0, 0)) == 0);
}

TEST_CASE("scattered and reflected and refracted light have their weights") {
    Random random(GENERATE(range(0u, 100u)));
    const float r = random.real(0, 0.6), t = random.real(0, 0.4);
    // Blue is scattered by the pane, green comes from the sky, red from the cellar below.
    Scene scene = litFloor(Material(Color(0, 0, 1), r, t, 1), Light(Vec3(0, 0, 10)));
    scene.push(tile(-5, Material(Color(1, 0, 0))));
    scene.push(Light(Vec3(5, 0, -4)));
    scene.setBackground(Color(0, 1, 0));
    const double rest = 1 - static_cast<double>(r) - static_cast<double>(t);
    CAPTURE(r, t);
    CHECK(distance(lab::traceRay(slanted, scene, 0), dvec3(0, 0, rest)) < 1e-6);
    for (const int depth : {1, 2, 10})
        CHECK(distance(lab::traceRay(slanted, scene, depth), dvec3(t, r, rest)) < 1e-6);
}

TEST_CASE("no shadow ray is cast where its light would not count") {
    const Light above(Vec3(0, 0, 8)), below(Vec3(0, 0, -8)), level(Vec3(5, 0, 0));
    const auto shadowRays = [](const Material& material, const Light& light) {
        return trace(downwards, litFloor(material, light), 0).count[RayKind::shadow];
    };
    CHECK(shadowRays(white, above) == 1);
    CHECK(shadowRays(white, below) == 0);
    CHECK(shadowRays(white, level) == 0);
    CHECK(shadowRays(Material(Color(1, 1, 1), 0.5f, 0.25f, 1.5f), above) == 1);
    CHECK(shadowRays(Material(Color(1, 1, 1), 1), above) == 0);
    CHECK(shadowRays(Material(Color(1, 1, 1), 0, 1, 1.5f), above) == 0);
    CHECK(shadowRays(Material(Color(1, 1, 1), 0.2f, 0.8f, 1.3f), above) == 0);  // the lab's glass
}

TEST_CASE("one shadow ray is cast for every light that faces the surface") {
    const int facing = GENERATE(0, 1, 2, 5);
    Scene scene;
    scene.push(tile(0, white));
    for (int i = 0; i < facing; ++i) scene.push(Light(Vec3(static_cast<float>(i), 0, 5)));
    for (int i = 0; i < 3; ++i) scene.push(Light(Vec3(static_cast<float>(i), 0, -5)));
    const RayCount count = trace(downwards, scene, 3).count;
    CHECK(count[RayKind::shadow] == static_cast<unsigned>(facing));
    CHECK(count.total() == static_cast<unsigned>(facing) + 1);
}

TEST_CASE("no secondary ray is cast where its weight is zero") {
    const float r = GENERATE(0.f, 0.5f), t = GENERATE(0.f, 0.5f);
    const int depth = GENERATE(0, 1, 5);
    CAPTURE(r, t, depth);
    const Scene scene = litFloor(Material(Color(1, 1, 1), r, t, 1.5f), Light(Vec3(0, 0, -8)));
    const RayCount count = trace(slanted, scene, depth).count;
    CHECK(count[RayKind::reflected] == (r > 0 && depth > 0 ? 1u : 0u));
    CHECK(count[RayKind::refracted] == (t > 0 && depth > 0 ? 1u : 0u));
    CHECK(count[RayKind::shadow] == 0);
    CHECK(count[RayKind::other] == 1);
}
