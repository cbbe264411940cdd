#pragma once

#include <string>
#include <vector>

#include "lab/lightAndFloor.h"

/// What the rays that were sent tell about a wrong shadow. Nothing is said unless they explain it.
namespace lab {

/// How nearly two vectors point the same way.
inline bool parallel(const sw::Vec3& a, const sw::Vec3& b) {
    return a * b > 0.9999f * a.norm() * b.norm();
}

/// The shadow ray, if it is clear which one that is: getShadowRay() marks it, or it is the only
/// one.
inline const sw::Ray* shadowRayAmong(const Asked& rays) {
    if (rays.size() == 1) return &rays.front();
    const sw::Ray* found = nullptr;
    for (const sw::Ray& ray : rays)
        if (ray.kind == sw::RayKind::shadow) {
            if (found) return nullptr;
            found = &ray;
        }
    return found;
}

/// Whether a later ray than the first started on the thing: only one does that goes on from a hit.
inline bool wentOnFrom(const sw::Sphere& thing, const Asked& rays) {
    for (std::size_t i = 1; i < rays.size(); ++i)
        if (std::fabs((rays[i].orig - thing.center).norm() - thing.radius) < 0.05f) return true;
    return false;
}

constexpr const char* hitOverwritten =
    "the shadow ray's hit takes the place of the first one: what follows is about the thing in the "
    "way, and not about the surface any more";

/// What is wrong with the way of a shadow ray that starts at the surface.
inline std::string wrongWay(const sw::Ray& ray, const sw::Vec3& from, const sw::Vec3& light) {
    sw::Vec3 toLight = light - from;
    if ((ray.orig - from).norm() > 0.2f || parallel(ray.dir, toLight)) return "";
    if (parallel(ray.dir, -toLight))
        return "the shadow ray runs away from the light: its way leads from the surface to it";
    if (parallel(ray.dir, light))
        return "the place of the light is taken for the shadow ray's direction: the way to it "
               "begins at the surface";
    if (parallel(ray.dir, toLight.normalize() - ray.orig))
        return "the direction to the light is taken for a place, where the shadow ray ends: "
               "getShadowRay() asks for the place of the light";
    return "";
}

/// Where a ray on the right line starts or ends too early or too late.
/// @param where  of the thing, which it meets though it should not, or the other way round
inline std::string wrongEnds(const sw::Ray& ray, const sw::Vec3& from, const sw::Vec3& light,
                             const sw::Sphere& thing) {
    const sw::Vec3 toLight = light - from;
    const float reach = toLight.norm(), where = (thing.center - from) * toLight / reach;
    if (parallel(ray.dir, -toLight) && (ray.orig - light).norm() < 0.1f * reach && where < 0)
        return "a ray that comes from the light has to end at the surface: what lies behind that "
               "is in nobody's way";
    if (!parallel(ray.dir, toLight) || (ray.orig - from) * toLight > reach * reach) return "";
    const float scale = ray.dir.norm(), start = (ray.orig - from) * toLight / reach;
    if (where > reach && start + ray.maxT * scale > reach + thing.radius / 2)
        return "what stands beyond a light does not hide it: the shadow ray has to end at the "
               "light";
    if (where < 0) return "";
    if (start + ray.maxT * scale < where)
        return "the shadow ray ends before it is at the light: maxT counts in units of the "
               "direction, as t does";
    if (start + ray.minT * scale > where)
        return "things near the surface are overlooked: the shadow ray begins too far off it";
    return "";
}

/// What is no colour at all, by its name; unless shading (task 1) makes such a thing of all light.
inline std::string newFault(const sw::Color& got, const Shades& shades) {
    return faultOfColor(shades.lit).empty() ? faultOfColor(got) : "";
}

/// Why the thing does or does not hide the light, wrongly.
/// @param rays    that the student's code sent after the eye's
/// @param hidden  what came out
inline std::string whyWrong(const Asked& rays, const sw::Vec3& from, const sw::Vec3& light,
                            const sw::Sphere& thing, bool hidden) {
    const sw::Ray* ray = shadowRayAmong(rays);
    if (!ray) return "";
    sw::Intersection hit;
    const bool met = thing.intersect(*ray, hit);
    if (met && !hidden && parallel(ray->dir, light - from))
        return "the shadow ray meets what stands in the way, and the light counts all the same: "
               "every hit between the surface and the light is a shadow";
    if (met != hidden) return "";
    const std::string way = wrongWay(*ray, from, light);
    return way.empty() ? wrongEnds(*ray, from, light, thing) : way;
}

}  // namespace lab
