#include <memory>

#include "lab/matte.h"
#include "lab/photo.h"
#include "lab/teach.h"
#include "tools/common/mainFunctions.h"

using namespace sw;

namespace {

const Vec3 eye(0, 0, 12);

// Seen by the eye alone, so that none casts a shadow, whatever becomes of task 3.
class SeenSphere : public Sphere {
public:
    using Sphere::Sphere;
    bool intersect(const Ray& ray, Intersection& hit) const override {
        return (ray.orig - eye).isZero() && Sphere::intersect(ray, hit);
    }
};

Scene spheres() {
    Scene scene;
    const auto add = [&](const Vec3& centre, float radius, const Color& color) {
        scene.push(std::make_shared<SeenSphere>(centre, radius, lab::matte(color)));
    };
    add({-1.7f, 1.2f, 0}, 1.9f, {1, 0.6f, 0.1f});
    add({2, 0.8f, 1}, 1.4f, {0.1f, 0.6f, 0.2f});
    add({0.3f, -2.1f, 2}, 1.2f, {0.9f, 0.9f, 0.9f});
    return scene;
}

}  // namespace

TEST_CASE("lights round some spheres: the picture", "[lab1]") {
    Scene scene = spheres();
    scene.push(Light({-6, 7, 9}, {0.8f, 0.8f, 0.8f}));
    scene.push(Light({9, -3, 4}, {0.1f, 0.15f, 0.5f}));
    const Image image = lab::photo(Camera(eye, {0, 0, 0}, {0, 1, 0}, 40),
                                   [&](const Ray& ray) { return lab::traceRay(ray, scene, 0); });
    lab::expectPicture("lab1-spheres", image, 2, 8,
                       {"three spheres under a white and a blue light",
                        "look for the place that differs most, and ask for both lights how the "
                        "surface is turned to them there"});
}
