#include "swTriangle.h"

#include <cmath>

namespace sw {

bool Triangle::intersect(const Ray& ray, Intersection& hit) const {
    // TODO 2, ray-triangle intersection: where does the ray meet the plane of the vertices? Is
    // that t between ray.minT and ray.maxT, and the point inside the triangle? If so, fill in
    // hit: hitT, position, normal (turned against the ray), frontFacing, material and ray.
    return false;
}

Bounds Triangle::bounds() const {
    Bounds box;
    for (const Vec3& v : vertices) box.add(v);
    return box;
}

}  // namespace sw
