#pragma once

#include "swBounds.h"
#include "swIntersection.h"
#include "swMaterial.h"
#include "swRay.h"

namespace sw {

/// Anything that a ray can hit. A primitive of your own needs only intersect().
class Primitive {
public:
    Material material;

    Primitive() = default;
    explicit Primitive(const Material& material) : material(material) {}
    virtual ~Primitive() = default;

    /// Finds the nearest hit with ray.minT < t < ray.maxT. Called from several threads at once.
    /// @param hit  on a hit, its position, normal (unit, against the ray), hitT, frontFacing,
    ///             material and ray are set; on a miss its content is undefined
    /// @return     true if there is a hit; a NaN anywhere is a miss
    virtual bool intersect(const Ray& ray, Intersection& hit) const = 0;

    /// A box that holds the whole primitive. A primitive without one is tested against every ray.
    virtual Bounds bounds() const { return Bounds::unbounded(); }
};

}  // namespace sw
