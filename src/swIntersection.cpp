#include "swIntersection.h"

#include "leave.h"
#include "swNumerics.h"
// kit >>>
//| #include "todo.h"
// <<<

namespace sw {
// tasks 4 and 5, formulas >>>
//|
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

// <<<
Ray Intersection::getShadowRay(const Vec3& lightPos) const {
    // The direction is rounded, so origin + 1 * direction may lie 2u beyond the light; 4u = 2^-22.
    constexpr float shortOfLight = 1 - 0x1p-22f;
    const Vec3 origin =
        num::offsetFromSurface(position, trueNormal(*this), num::statedOrDefaultError(*this));
    return Ray(origin, lightPos - origin, 0, shortOfLight, RayKind::shadow);
}

Ray Intersection::getReflectedRay() const {
    // task 4 >>>
    //| // TODO 4, reflection: into which direction does a mirror with this normal send ray.dir? It
    //| // is to have length 1, which ray.dir need not have. leave() in leave.h makes the ray.
    //| return todo::reflectedRay(*this);
    const dvec3 d = unit(ray.dir);
    dvec3 reflected = mirror(d, unit(normal));
    if (isBent(*this)) {
        const dvec3 up = unit(geometricNormal);
        if (!(dot(reflected, up) > 0)) reflected = mirror(d, up);
    }
    return leave(*this, trueNormal(*this), num::toFloat(reflected), RayKind::reflected);
    // <<<
}

Ray Intersection::getRefractedRay() const {
    // task 5 >>>
    //| // TODO 5, refraction: which direction does Snell's law give? frontFacing tells whether the
    //| // ray enters the material or leaves it. Where nothing is refracted, all is reflected.
    //| return todo::refractedRay(*this);
    const dvec3 d = unit(ray.dir);
    const double index = material.refractiveIndex;
    const double eta = frontFacing ? 1 / index : index;
    Refracted refracted = refract(d, unit(normal), eta);
    if (isBent(*this)) {
        const dvec3 up = unit(geometricNormal);
        const double height = dot(refracted.direction, up);
        if (!(refracted.passes ? height < 0 : height > 0)) refracted = refract(d, up, eta);
    }
    const Vec3& side = trueNormal(*this);
    return leave(*this, refracted.passes ? -side : side, num::toFloat(refracted.direction),
                 RayKind::refracted);
    // <<<
}

}  // namespace sw
