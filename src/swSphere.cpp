#include "swSphere.h"

#include <utility>

#include "swNumerics.h"

namespace sw {

using glm::dvec3;

bool Sphere::intersect(const Ray& ray, Intersection& hit) const {
    const dvec3 d = num::toDouble(ray.dir);
    const dvec3 f = num::toDouble(ray.orig) - num::toDouble(center);
    const double r = std::fabs(radius);
    const double a = dot(d, d);

    // |f x d|^2 / |d|^2 is the squared distance from centre to line: r^2 minus it subtracts two
    // like-sized numbers, where b^2 - ac subtracts two huge ones (Haines et al., Ray Tracing Gems,
    // ch. 7).
    const dvec3 x = cross(f, d);
    const double discriminant = r * r * a - dot(x, x);
    if (!(discriminant >= 0 && r > 0)) return false;  // miss, or NaN

    // q adds numbers of one sign; the roots are q / a and, as their product is (f.f - r^2) / a,
    // (f.f - r^2) / q.
    const double b = -dot(f, d);
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    double entry = q / a;
    double exit = (dot(f, f) - r * r) / q;
    if (!std::signbit(b)) std::swap(entry, exit);

    const bool fromOutside = radius > 0 && ray.contains(static_cast<float>(entry));
    if (!fromOutside && !ray.contains(static_cast<float>(exit))) return false;

    const double t = fromOutside ? entry : exit;
    const dvec3 outward = glm::normalize(f + t * d);
    hit.hitT = static_cast<float>(t);
    // From the centre, not along the ray: exact however far the ray came.
    hit.position = num::toFloat(num::toDouble(center) + r * outward);
    hit.setFace(num::toFloat(outward), fromOutside, radius < 0);
    hit.material = material;
    hit.ray = ray;
    hit.positionError = num::surfaceError(hit.position, 2 * std::fabs(radius));
    return true;
}

Bounds Sphere::bounds() const {
    // Each coordinate may be off by half an ulp: one step outwards makes up for it.
    const float r = std::fabs(radius);
    Bounds box;
    for (int i = 0; i < 3; ++i) {
        box.min[i] = std::nextafter(center[i] - r, -Bounds::infinity);
        box.max[i] = std::nextafter(center[i] + r, Bounds::infinity);
    }
    return box;
}

}  // namespace sw
