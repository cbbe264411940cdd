#include "swScene.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "accel/shapeLeaves.h"
#include "accel/shapePackets.h"
#include "accel/shapeSet.h"
#include "swRayCount.h"

namespace sw {

struct Scene::Content {
    template <typename Shape>
    using PlainSet = ShapeSet<Shape, PlainPacket, PlainLeaves<Shape>>;

    ShapeSet<Sphere, SpherePacket, SphereLeaves> spheres;
    ShapeSet<Triangle, TrianglePacket, TriangleLeaves> triangles;
    PlainSet<Cone> cones;
    PlainSet<Patch> patches;
    PlainSet<std::shared_ptr<Primitive>> others;
    std::vector<Light> lights;
    Color background;
    bool onlySpheresAndTriangles = true;

    Content() = default;
    Content(const Content& other)
        : spheres(other.spheres),
          triangles(other.triangles),
          cones(other.cones),
          patches(other.patches),
          others(other.others),
          lights(other.lights),
          background(other.background) {}

    // Prepares the content for queries; the first thread to ask does the work.
    void prepare() {
        if (ready.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(preparing);
        if (ready.load(std::memory_order_relaxed)) return;
        const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
        spheres.prepare(threads);
        triangles.prepare(threads);
        cones.prepare(threads);
        patches.prepare(threads);
        others.prepare(threads);
        onlySpheresAndTriangles = cones.size() + patches.size() + others.size() == 0;
        ready.store(true, std::memory_order_release);
    }

    // Returns whether the search is over.
    bool find(Search& search) const {
        if (spheres.find(search) || triangles.find(search)) return true;
        if (onlySpheresAndTriangles) return false;
        return cones.find(search) || patches.find(search) || others.find(search);
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
void Scene::push(const Cone& cone) {
    ownContent().cones.push(cone);
}
void Scene::push(const Patch& patch) {
    ownContent().patches.push(patch);
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

SceneParts Scene::parts() const {
    prepare();
    const Content& c = *content;
    return {{{"spheres", c.spheres.size()},
             {"triangles", c.triangles.size()},
             {"cones", c.cones.size()},
             {"patches", c.patches.size()},
             {"other", c.others.size()}},
            c.spheres.hasTree() || c.triangles.hasTree() || c.cones.hasTree() ||
                c.patches.hasTree() || c.others.hasTree()};
}

bool Scene::intersect(const Ray& ray, Intersection& hit, bool any) const {
    if (&ray == &hit.ray) {  // which the search would overwrite
        const Ray copy = ray;
        return intersect(copy, hit, any);
    }
    content->prepare();
    Search search(ray, hit, any);
    content->find(search);
    if (search.found) search.finish();
    countRay(ray.kind, search.found);
    return search.found;
}

}  // namespace sw
