#include "swScene.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "accel/shapeIndex.h"
#include "swRayCount.h"

namespace sw {

struct Scene::Content {
    ShapeIndex shapes;
    std::vector<Light> lights;
    Color background;

    Content() = default;
    Content(const Content& other)
        : shapes(other.shapes), lights(other.lights), background(other.background) {}

    // Prepares the content for queries; the first thread to ask does the work.
    void prepare() {
        if (ready.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(preparing);
        if (ready.load(std::memory_order_relaxed)) return;
        shapes.prepare(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
        ready.store(true, std::memory_order_release);
    }

    std::atomic<bool> ready{false};
    std::mutex preparing;
};

Scene::Scene() : content(std::make_shared<Content>()) {}

Scene::Content& Scene::ownContent() {
    if (content.use_count() > 1) content = std::make_shared<Content>(*content);
    content->ready = false;
    return *content;
}

void Scene::push(const Sphere& sphere) {
    ownContent().shapes.push(sphere);
}
void Scene::push(const Triangle& triangle) {
    ownContent().shapes.push(triangle);
}
void Scene::push(const Cone& cone) {
    ownContent().shapes.push(cone);
}
void Scene::push(const Patch& patch) {
    ownContent().shapes.push(patch);
}
void Scene::push(std::shared_ptr<Primitive> primitive) {
    if (primitive) ownContent().shapes.push(std::move(primitive));
}
void Scene::push(const Light& light) {
    ownContent().lights.push_back(light);
}
void Scene::setBackground(const Color& color) {
    ownContent().background = color;
}

const std::vector<Light>& Scene::lights() const {
    return content->lights;
}
const Color& Scene::background() const {
    return content->background;
}

void Scene::prepare() const {
    content->prepare();
}

SceneParts Scene::parts() const {
    prepare();
    const auto [spheres, triangles, cones, patches, others] = content->shapes.sizes();
    return {{{"spheres", spheres},
             {"triangles", triangles},
             {"cones", cones},
             {"patches", patches},
             {"other", others}},
            content->shapes.hasTree()};
}

bool Scene::intersect(const Ray& ray, Intersection& hit, bool any) const {
    if (&ray == &hit.ray) {  // which the search would overwrite
        const Ray copy = ray;
        return intersect(copy, hit, any);
    }
    content->prepare();
    const bool found = content->shapes.find(ray, hit, any);
    countRay(ray.kind, found);
    return found;
}

bool Scene::isOccluded(const Ray& ray) const {
    content->prepare();
    const bool found = content->shapes.isHit(ray);
    countRay(ray.kind, found);
    return found;
}

}  // namespace sw
