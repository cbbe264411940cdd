#include "swIntersection.h"

#include <cmath>

#include "swNumerics.h"

namespace sw {

float Intersection::errorBound() const {
    if (positionError >= 0) return positionError;
    return 0x1p-14f * (num::maxAbs(position) + std::fabs(hitT) * ray.dir.norm());
}

Ray Intersection::spawnRay(const Vec3& direction, const Vec3& side, RayKind kind) const {
    return Ray(num::offsetFromSurface(position, side, errorBound()), direction, 0, FLT_MAX, kind);
}

Ray Intersection::getShadowRay(const Vec3& lightPos) const {
    // The direction is rounded, so origin + direction may lie 2u beyond the light; 4u = 2^-22.
    constexpr float shortOfLight = 1 - 0x1p-22f;
    const Vec3 origin = num::offsetFromSurface(position, surfaceNormal(), errorBound());
    return Ray(origin, lightPos - origin, 0, shortOfLight, RayKind::shadow);
}

Ray Intersection::getReflectedRay() const {
    // TODO 4, reflection: into which direction does a mirror with this normal send ray.dir? It is
    // to have length 1, which ray.dir need not have. spawnRay() makes the ray.
    return Ray();
}

Ray Intersection::getRefractedRay() const {
    // TODO 5, refraction: which direction does Snell's law give? frontFacing tells whether the ray
    // enters the material or leaves it. Where nothing is refracted, all is reflected.
    return Ray();
}

}  // namespace sw
