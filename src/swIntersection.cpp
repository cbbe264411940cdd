#include "swIntersection.h"

#include "swNumerics.h"
#include "swStop.h"

namespace sw {
namespace {

using glm::dvec3;

// Mirrors d at the plane with normal n; both of unit length.
dvec3 mirror(const dvec3& d, const dvec3& n) {
    return glm::normalize(d - 2 * dot(d, n) * n);
}

dvec3 unit(const Vec3& v) {
    return glm::normalize(num::toDouble(v));
}

// A direction, and whether it passes through the surface.
struct Refracted {
    dvec3 direction;
    bool passes;
};

// Refracts d at the plane with normal n; both of unit length. eta: the factor of Snell's law.
Refracted refract(const dvec3& d, const dvec3& n, double eta) {
    // c = 1 - eta^2 sin^2 is the squared cosine of the refracted ray. The cross product gives the
    // sine itself; 1 - cos^2 would lose half of its digits near the critical angle.
    const dvec3 sine = cross(n, d);
    const double c = 1 - eta * eta * dot(sine, sine);
    if (!(c >= 0)) return {mirror(d, n), false};  // total internal reflection
    return {glm::normalize(eta * d - (eta * dot(d, n) + std::sqrt(c)) * n), true};
}

}  // namespace

float Intersection::errorBound() const {
    if (positionError >= 0) return positionError;
    return 0x1p-14f * (num::maxAbs(position) + std::fabs(hitT) * ray.dir.norm());
}

Ray Intersection::spawnRay(const Vec3& direction, const Vec3& side, RayKind kind) const {
    Ray spawned(num::offsetFromSurface(position, side, errorBound()), direction, 0, FLT_MAX, kind);
    checkStop(ray, spawned);
    return spawned;
}

Ray Intersection::getShadowRay(const Vec3& lightPos) const {
    // The direction is rounded, so origin + direction may lie 2u beyond the light; 4u = 2^-22.
    constexpr float shortOfLight = 1 - 0x1p-22f;
    const Vec3 origin = num::offsetFromSurface(position, surfaceNormal(), errorBound());
    return Ray(origin, lightPos - origin, 0, shortOfLight, RayKind::shadow);
}

Ray Intersection::getReflectedRay() const {
    const dvec3 d = unit(ray.dir);
    dvec3 reflected = mirror(d, unit(normal));
    if (hasShadingNormal()) {
        const dvec3 up = unit(geometricNormal);
        if (!(dot(reflected, up) > 0)) reflected = mirror(d, up);
    }
    return spawnRay(num::toFloat(reflected), surfaceNormal(), RayKind::reflected);
}

Ray Intersection::getRefractedRay() const {
    const dvec3 d = unit(ray.dir);
    const double index = material.refractiveIndex;
    const double eta = frontFacing ? 1 / index : index;
    Refracted refracted = refract(d, unit(normal), eta);
    if (hasShadingNormal()) {
        const dvec3 up = unit(geometricNormal);
        const double height = dot(refracted.direction, up);
        if (!(refracted.passes ? height < 0 : height > 0)) refracted = refract(d, up, eta);
    }
    const Vec3& up = surfaceNormal();
    return spawnRay(num::toFloat(refracted.direction), refracted.passes ? -up : up,
                    RayKind::refracted);
}

}  // namespace sw
