#include "swScene.h"

#include "swRayCount.h"

namespace sw {

// Primitives by type: neighbours in memory, and called directly instead of through a table.
struct Scene::Content {
    std::vector<Sphere> spheres;
    std::vector<Triangle> triangles;
    std::vector<std::shared_ptr<Primitive>> others;
    std::vector<Light> lights;
    Color background;
};

namespace {

// Looks for hits along one ray, and shortens it to the nearest one so far.
class Search {
public:
    Search(const Ray& ray, Intersection& result, bool anyHit)
        : rest(ray), nearest(result), any(anyHit) {}

    // Returns whether the search is over.
    template <typename Shape>
    bool test(const Shape& shape) {
        // The candidate is a record of its own: a primitive may scribble into it before it knows
        // that it is missed, and may leave positionError unstated.
        if (!shape.Shape::intersect(rest, candidate)) return false;
        return accept();
    }
    bool test(const std::shared_ptr<Primitive>& shape) {
        if (!shape->intersect(rest, candidate)) return false;
        // A student's primitive may get this wrong, and one NaN would hide all that is behind it.
        if (!(rest.minT < candidate.hitT && candidate.hitT < rest.maxT)) return false;
        return accept();
    }

    bool found = false;

private:
    bool accept() {
        found = true;
        nearest = candidate;
        candidate.positionError = -1;
        rest.maxT = nearest.hitT;
        return any;
    }

    Ray rest;
    Intersection& nearest;
    Intersection candidate;
    bool any;
};

template <typename Shapes>
bool testAll(const Shapes& shapes, Search& search) {
    for (const auto& shape : shapes)
        if (search.test(shape)) return true;
    return false;
}

}  // namespace

Scene::Scene() : content(std::make_shared<Content>()) {}

Scene::Content& Scene::ownContent() {
    if (content.use_count() > 1) content = std::make_shared<Content>(*content);
    return *content;
}

void Scene::push(const Sphere& sphere) {
    ownContent().spheres.push_back(sphere);
}
void Scene::push(const Triangle& triangle) {
    ownContent().triangles.push_back(triangle);
}
void Scene::push(std::shared_ptr<Primitive> primitive) {
    if (primitive) ownContent().others.push_back(std::move(primitive));
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

bool Scene::intersect(const Ray& ray, Intersection& hit, bool any) const {
    Search search(ray, hit, any);
    testAll(content->triangles, search) || testAll(content->spheres, search) ||
        testAll(content->others, search);
    if (search.found) hit.ray = ray;
    countRay(ray.kind, search.found);
    return search.found;
}

}  // namespace sw
