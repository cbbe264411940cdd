#ifndef SW_SCENE_H
#define SW_SCENE_H

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "swCone.h"
#include "swLight.h"
#include "swPatch.h"
#include "swPrimitive.h"
#include "swSphere.h"
#include "swTriangle.h"

namespace sw {

/// What a scene consists of, and whether any part of it is in a tree.
struct SceneParts {
    std::vector<std::pair<const char*, std::size_t>> counts;  ///< {"spheres", 7} for example
    bool tree = false;
};

/// Primitives, lights and a background. Copies are cheap: they share their content until one of
/// them changes. Queries may run in many threads at once, changes only while no query runs.
class Scene {
public:
    Scene();
    Scene(const Scene&) = default;  // no move: it would leave a scene without content
    Scene& operator=(const Scene&) = default;

    void push(const Sphere& sphere);
    void push(const Triangle& triangle);
    void push(const Cone& cone);
    void push(const Patch& patch);
    /// For other primitives, such as a student's own. A null pointer is ignored.
    void push(std::shared_ptr<Primitive> primitive);
    void push(const Light& light);
    void setBackground(const Color& color);

    const std::vector<Light>& lights() const;
    /// The colour that a ray brings back if it hits nothing; black unless set.
    const Color& background() const;

    /// Finds what the ray hits with minT < t < maxT.
    /// @param hit  the nearest hit, or with `any` just one of the hits; without a hit, its content
    ///             is undefined
    /// @param any  true: stop at the first hit found, which is enough for shadow rays
    bool intersect(const Ray& ray, Intersection& hit, bool any = false) const;
    bool intersect(const Ray* ray, Intersection& hit, bool any = false) const {
        return intersect(*ray, hit, any);
    }

    /// Whether the ray hits anything with minT < t < maxT: faster than intersect(), as it need not
    /// know what. For shadow rays.
    bool isOccluded(const Ray& ray) const;

    /// Arranges the primitives for fast search. Otherwise the first query does so.
    void prepare() const;

    /// Prepares the scene and returns what it consists of.
    SceneParts parts() const;

private:
    struct Content;
    Content& ownContent();

    std::shared_ptr<Content> content;
};

}  // namespace sw

#endif
