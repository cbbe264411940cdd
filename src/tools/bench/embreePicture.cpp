#include <embree3/rtcore.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "swSampling.h"
#include "tools/bench/picture.h"
#include "tools/bench/textbook.h"

namespace bench {
namespace {

using namespace textbook;

// The room as Embree sees it: each triangle a mesh, each sphere a set of one point.
class Room {
public:
    Room() : device(rtcNewDevice("threads=1,set_affinity=0")) {
        if (!device) throw std::runtime_error("Embree does not start");
        scene = rtcNewScene(device);
        for (const RoomTriangle& t : roomTriangles()) {
            const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            std::memcpy(buffer(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, 3), t.v, 36);
            const unsigned indices[] = {0, 1, 2};
            std::memcpy(buffer(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, 1), indices, 12);
            attach(mesh, t.material);
        }
        for (const RoomSphere& s : roomSpheres()) {
            const RTCGeometry points = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
            const float sphere[] = {s.center[0], s.center[1], s.center[2], roomSphereRadius};
            std::memcpy(buffer(points, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 1), sphere,
                        16);
            attach(points, s.material);
        }
        rtcCommitScene(scene);
    }
    ~Room() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    bool intersect(const Ray& ray, Hit& hit) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query;
        query.ray = convert(ray);
        query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &query);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
        hit.hitT = query.ray.tfar;
        hit.position = ray.orig + hit.hitT * ray.dir;
        hit.normal = normalized({query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z});
        hit.frontFacing = hit.normal * ray.dir < 0;
        if (!hit.frontFacing) hit.normal = -hit.normal;
        hit.material = materials[query.hit.geomID];
        hit.ray = ray;
        return true;
    }

    bool occluded(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay query = convert(ray);
        rtcOccluded1(scene, &context, &query);
        return query.tfar < 0;
    }

private:
    static void* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                        std::size_t size, std::size_t count) {
        return rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count);
    }
    void attach(RTCGeometry geometry, const Material& material) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);  // numbers them in this order
        rtcReleaseGeometry(geometry);
        materials.push_back(material);
    }
    static RTCRay convert(const Ray& ray) {
        RTCRay r;
        r.org_x = ray.orig[0], r.org_y = ray.orig[1], r.org_z = ray.orig[2];
        r.dir_x = ray.dir[0], r.dir_y = ray.dir[1], r.dir_z = ray.dir[2];
        r.tnear = ray.minT, r.tfar = ray.maxT;
        r.time = 0;
        r.mask = ~0u;
        r.id = r.flags = 0;
        return r;
    }

    RTCDevice device;
    RTCScene scene;
    std::vector<Material> materials;
};

Vec3 traceRay(const Ray& ray, const Room& room, int depth) {
    Hit hit;
    if (!room.intersect(ray, hit)) return {};
    const Material& material = hit.material;
    const float r = material.reflectivity, t = material.transparency;
    Vec3 color;
    if (1 - r - t > 0) {
        const float cosine = hit.normal * normalized(roomLight - hit.position);
        if (cosine > 0 && !room.occluded(hit.getShadowRay(roomLight)))
            color = (1 - r - t) * cosine * material.color;
    }
    if (depth > 0 && r > 0) color += r * traceRay(hit.getReflectedRay(), room, depth - 1);
    if (depth > 0 && t > 0) color += t * traceRay(hit.getRefractedRay(), room, depth - 1);
    return color;
}

}  // namespace

Radiance embreesPicture(int size) {
    return [room = std::make_shared<Room>(), camera = Camera(size)](int x, int y) {
        constexpr float n = labSamples;
        Vec3 sum;
        for (float j = 0; j < n; ++j) {
            for (float i = 0; i < n; ++i) {
                const float dx = (i + sw::uniform()) / n, dy = (j + sw::uniform()) / n;
                const Ray ray =
                    camera.getRay(static_cast<float>(x) + dx, static_cast<float>(y) + dy);
                sum += traceRay(ray, *room, labDepth);
            }
        }
        return sum * (1 / (n * n));
    };
}

}  // namespace bench
