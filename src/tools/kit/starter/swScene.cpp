#include "swScene.h"

#include "swRayCount.h"

namespace sw {

Scene::Scene() : content(std::make_shared<Content>()) {}

Scene::Content& Scene::ownContent() {
    if (content.use_count() > 1) content = std::make_shared<Content>(*content);
    return *content;
}

void Scene::push(const Sphere& sphere) {
    push(std::make_shared<Sphere>(sphere));
}
void Scene::push(const Triangle& triangle) {
    push(std::make_shared<Triangle>(triangle));
}
void Scene::push(std::shared_ptr<Primitive> primitive) {
    if (primitive) ownContent().primitives.push_back(std::move(primitive));
}
void Scene::push(const Light& light) {
    ownContent().lights.push_back(light);
}
void Scene::setBackground(const Color& color) {
    ownContent().background = color;
}

SceneParts Scene::parts() const {
    return {{{"primitives", content->primitives.size()}}};
}

// Asks every primitive. The ray gets shorter with every hit, so that only nearer ones count.
bool Scene::intersect(const Ray& ray, Intersection& hit, bool any) const {
    const Ray asked = ray;  // which may be part of the hit
    Ray rest = asked;
    bool found = false;
    for (const auto& primitive : content->primitives) {
        Intersection candidate;
        if (!primitive->intersect(rest, candidate) || !rest.contains(candidate.hitT)) continue;
        hit = candidate;
        hit.ray = asked;
        found = true;
        if (any) break;
        rest.maxT = candidate.hitT;
    }
    countRay(asked.kind, found);
    return found;
}

}  // namespace sw
