#pragma once

#include <embree3/rtcore.h>

/// Rays for Embree, one by one. A ray is a struct with orig, dir, minT and maxT.
namespace bench {

/// Embree, started for one thread. The caller releases it.
/// @throws std::runtime_error
RTCDevice startEmbree();

template <typename Ray>
RTCRay toEmbree(const Ray& ray) {
    RTCRay r;
    r.org_x = ray.orig[0], r.org_y = ray.orig[1], r.org_z = ray.orig[2];
    r.dir_x = ray.dir[0], r.dir_y = ray.dir[1], r.dir_z = ray.dir[2];
    r.tnear = ray.minT, r.tfar = ray.maxT;
    r.time = 0;
    r.mask = ~0u;
    r.id = r.flags = 0;
    return r;
}

/// The nearest hit; on a miss its geomID is RTC_INVALID_GEOMETRY_ID.
template <typename Ray>
RTCRayHit nearestHit(RTCScene scene, RTCIntersectContext& context, const Ray& ray) {
    RTCRayHit query;
    query.ray = toEmbree(ray);
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &query);
    return query;
}

template <typename Ray>
bool isOccluded(RTCScene scene, RTCIntersectContext& context, const Ray& ray) {
    RTCRay query = toEmbree(ray);
    rtcOccluded1(scene, &context, &query);
    return query.tfar < 0;
}

}  // namespace bench
