#include <memory>

#include "lab/lambertMistakes.h"
#include "lab/photo.h"
#include "lab/spot.h"
#include "lab/teach.h"

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

Scene spheres(lab::Showing showing) {
    Scene scene;
    lab::coverIfNeeded(scene, eye, showing);
    const auto add = [&](const Vec3& centre, float radius, const Color& color) {
        scene.push(std::make_shared<SeenSphere>(centre, radius, lab::shownPaint(color, showing)));
    };
    add({-1.7f, 1.2f, 0}, 1.9f, {1, 0.6f, 0.1f});
    add({2, 0.8f, 1}, 1.4f, {0.1f, 0.6f, 0.2f});
    add({0.3f, -2.1f, 2}, 1.2f, {0.9f, 0.9f, 0.9f});
    return scene;
}

}  // namespace

TEST_CASE("lights round some spheres: the picture", "[lab1]") {
    Scene scene = spheres(lab::bestShowing());
    scene.push(Light({-6, 7, 9}, {0.8f, 0.8f, 0.8f}));
    scene.push(Light({9, -3, 4}, {0.1f, 0.15f, 0.5f}));
    const Image image = lab::photo(Camera(eye, {0, 0, 0}, {0, 1, 0}, 40), [&](const Ray& ray) {
        return lab::traceRay(ray, scene, lab::usualDepth);
    });
    lab::expectPicture(
        "lab1-spheres", image, 2, 8,
        {"three spheres under a white and a blue light", lab::lambertHint({{Light({-6, 7, 9})}})});
}
