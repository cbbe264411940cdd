#pragma once

#include "lab/suspects.h"

/// What can be said of a ray that goes on from a hit, whichever task made it.
namespace lab {

/// Exactly what the starter's getReflectedRay() and getRefractedRay() return.
inline bool isStarters(const sw::Ray& ray) {
    return ray.orig.isZero() && ray.dir.isZero() && ray.minT == 0 && ray.maxT == FLT_MAX;
}

inline sw::Vec3 startOf(const sw::Ray& ray) {
    return ray.orig + ray.minT * ray.dir;
}

/// What makes it no ray at all; empty if nothing does.
inline std::string noRayHint(const sw::Ray& ray) {
    if (!isNumber(ray.dir)) return faultOf(ray.dir);
    if (!isNumber(ray.orig)) return faultOf(ray.orig);
    if (ray.minT < ray.maxT) return "";
    return "this ray holds no point at all, as its minT, " + text(ray.minT) +
           ", is not less than its maxT, " + text(ray.maxT);
}

/// Why a ray that seems to have the right direction starts or ends in the wrong place.
/// @param side  unit normal on the side where it has to go on
inline std::string startHint(const sw::Ray& ray, const sw::Intersection& hit, const sw::Vec3& side,
                             const std::string& name) {
    if (const std::string hint = noRayHint(ray); !hint.empty()) return hint;
    if (ray.maxT < 1e6f)
        return "a " + name + " ray goes on for ever, but this one ends at maxT = " + text(ray.maxT);
    if (alike(ray.orig, hit.ray.orig)) return "this ray starts where the one came from that hit";
    if (ray.orig.isZero()) return "this ray starts at (0, 0, 0) and not where the surface was hit";
    const sw::Vec3 start = startOf(ray) - hit.position;
    if (start.norm() > 0.05f && alike(ray.orig, hit.position, 0.02f))
        return "this ray leaves out the way to t = " + text(ray.minT) +
               ", its minT: what stands there is not seen";
    if (start * side < 0)
        return "this ray starts on the wrong side of the surface: it has to start a little way off "
               "it on the side where it goes on";
    if (alike(ray.orig, hit.position, 0) && ray.minT * ray.dir.norm() < 1e-5f)
        return "rounding puts many hit points just beside the surface, so a " + name +
               " ray that starts exactly there may meet the same place again: it has to start a "
               "little way off, on the side where it goes on";
    return "";
}

/// NaN, infinite or negative colours of a picture; empty if there are none.
inline std::string faultOfPicture(const sw::Image& image) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const std::string fault = faultOfColor(image.at(x, y)); !fault.empty())
                return fault;
    return "";
}

}  // namespace lab
