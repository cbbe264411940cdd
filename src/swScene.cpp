#include "swScene.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "shapeSet.h"
#include "swRayCount.h"

namespace sw {

struct Scene::Content {
    ShapeSet<Sphere, SphereFilter> spheres;
    ShapeSet<Triangle, TriangleFilter> triangles;
    ShapeSet<std::shared_ptr<Primitive>, NoFilter> others;
    std::vector<Light> lights;
    Color background;

    Content() = default;
    Content(const Content& other)
        : spheres(other.spheres),
          triangles(other.triangles),
          others(other.others),
          lights(other.lights),
          background(other.background) {}

    // Does what the first query needs, whichever thread asks first.
    void prepare() {
        if (ready.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(preparing);
        if (ready.load(std::memory_order_relaxed)) return;
        const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        spheres.prepare(threads);
        triangles.prepare(threads);
        others.prepare(threads);
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
    ownContent().spheres.push(sphere);
}
void Scene::push(const Triangle& triangle) {
    ownContent().triangles.push(triangle);
}
void Scene::push(std::shared_ptr<Primitive> primitive) {
    if (primitive) ownContent().others.push(std::move(primitive));
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

bool Scene::intersect(const Ray& ray, Intersection& hit, bool any) const {
    content->prepare();
    const RayKind kind = ray.kind;  // the ray may be part of the hit record
    Search search(ray, hit, any);
    content->spheres.find(search) || content->triangles.find(search) ||
        content->others.find(search);
    if (search.found) search.finish();
    countRay(kind, search.found);
    return search.found;
}

}  // namespace sw
