#include "swIntersection.h"

#include "swNumerics.h"

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

Ray leave(const Intersection& hit, const Vec3& side, const dvec3& direction, RayKind kind) {
    const Vec3 origin = num::offsetFromSurface(hit.position, side, num::statedOrDefaultError(hit));
    return Ray(origin, num::toFloat(direction), 0, FLT_MAX, kind);
}

}  // namespace

Ray Intersection::getShadowRay(const Vec3& lightPos) const {
    // The direction is rounded, so origin + 1 * direction may lie 2u beyond the light; 4u = 2^-22.
    constexpr float shortOfLight = 1 - 0x1p-22f;
    const Vec3 origin = num::offsetFromSurface(position, normal, num::statedOrDefaultError(*this));
    return Ray(origin, lightPos - origin, 0, shortOfLight, RayKind::shadow);
}

Ray Intersection::getReflectedRay() const {
    return leave(*this, normal, mirror(unit(ray.dir), unit(normal)), RayKind::reflected);
}

Ray Intersection::getRefractedRay() const {
    const dvec3 d = unit(ray.dir);
    const dvec3 n = unit(normal);
    const double index = material.refractiveIndex;
    const double eta = frontFacing ? 1 / index : index;

    // c = 1 - eta^2 sin^2 is the squared cosine of the refracted ray. The cross product gives the
    // sine itself; 1 - cos^2 would lose half of its digits near the critical angle.
    const dvec3 sine = cross(n, d);
    const double c = 1 - eta * eta * dot(sine, sine);
    if (!(c >= 0)) return leave(*this, normal, mirror(d, n), RayKind::refracted);  // total

    const dvec3 refracted = eta * d - (eta * dot(d, n) + std::sqrt(c)) * n;
    return leave(*this, -normal, glm::normalize(refracted), RayKind::refracted);
}

}  // namespace sw
