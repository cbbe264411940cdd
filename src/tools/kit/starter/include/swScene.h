#ifndef SW_SCENE_H
#define SW_SCENE_H

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "swLight.h"
#include "swPrimitive.h"
#include "swSphere.h"
#include "swTriangle.h"

namespace sw {

/// What a scene consists of.
struct SceneParts {
    std::vector<std::pair<const char*, std::size_t>> counts;  ///< {"primitives", 7} for example
    bool tree = false;                                        ///< none in this lab
};

/// Primitives, lights and a background. Copies are cheap: they share their content until one of
/// them changes. Queries may run in many threads at once, changes only while no query runs.
class Scene {
public:
    Scene();
    Scene(const Scene&) = default;  // and no moving: it would leave a scene without content
    Scene& operator=(const Scene&) = default;

    void push(const Sphere& sphere);
    void push(const Triangle& triangle);
    /// For primitives of your own. A null pointer is ignored.
    void push(std::shared_ptr<Primitive> primitive);
    void push(const Light& light);
    void setBackground(const Color& color);

    const std::vector<Light>& lights() const { return content->lights; }
    /// What a ray that hits nothing brings back; black unless set.
    const Color& background() const { return content->background; }

    /// Finds what the ray hits with minT < t < maxT.
    /// @param hit  the nearest hit; with `any` just one of the hits; undefined if there is none
    /// @param any  true: stop at the first hit found, as suits a shadow ray
    bool intersect(const Ray& ray, Intersection& hit, bool any = false) const;
    bool intersect(const Ray* ray, Intersection& hit, bool any = false) const {
        return intersect(*ray, hit, any);
    }

    /// Whether the ray hits anything with minT < t < maxT. For shadow rays.
    bool isOccluded(const Ray& ray) const {
        Intersection hit;
        return intersect(ray, hit, true);
    }

    /// Does what the first query would do; here, nothing.
    void prepare() const {}
    SceneParts parts() const;

private:
    struct Content {
        std::vector<std::shared_ptr<Primitive>> primitives;
        std::vector<Light> lights;
        Color background;
    };
    Content& ownContent();

    std::shared_ptr<Content> content;
};

}  // namespace sw

#endif
