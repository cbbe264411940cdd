#include <cstring>
#include <memory>
#include <vector>

#include "tools/bench/embreeRays.h"
#include "tools/bench/room.h"
#include "tools/bench/textbook.h"

namespace bench {
namespace {

using namespace textbook;

// The room in Embree: each triangle is a mesh, each sphere a set of one point.
class EmbreeRoom {
public:
    Vec3 light;

    explicit EmbreeRoom(const Room& room)
        : light(room.light), device(startEmbree()), scene(rtcNewScene(device)) {
        for (const sw::Triangle& t : room.triangles) {
            const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            std::memcpy(buffer(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, 3), t.vertices,
                        36);
            const unsigned indices[] = {0, 1, 2};
            std::memcpy(buffer(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, 1), indices, 12);
            attach(mesh, t.material);
        }
        for (const sw::Sphere& s : room.spheres) {
            const RTCGeometry points = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
            const float sphere[] = {s.center[0], s.center[1], s.center[2], s.radius};
            std::memcpy(buffer(points, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 1), sphere,
                        16);
            attach(points, s.material);
        }
        rtcCommitScene(scene);
    }
    ~EmbreeRoom() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    EmbreeRoom(const EmbreeRoom&) = delete;
    EmbreeRoom& operator=(const EmbreeRoom&) = delete;

    bool intersect(const Ray& ray, Hit& hit) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        const RTCRayHit query = nearestHit(scene, context, ray);
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

    bool isOccluded(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        return bench::isOccluded(scene, context, ray);
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

    RTCDevice device;
    RTCScene scene;
    std::vector<Material> materials;
};

Vec3 traceRay(const Ray& ray, const EmbreeRoom& room, int depth) {
    Hit hit;
    if (!room.intersect(ray, hit)) return {};
    const Material& material = hit.material;
    const float r = material.reflectivity, t = material.transparency;
    Vec3 color;
    if (1 - r - t > 0) {
        const float cosine = hit.normal * normalized(room.light - hit.position);
        if (cosine > 0 && !room.isOccluded(hit.getShadowRay(room.light)))
            color = (1 - r - t) * cosine * material.color;
    }
    if (depth > 0 && r > 0) color += r * traceRay(hit.getReflectedRay(), room, depth - 1);
    if (depth > 0 && t > 0) color += t * traceRay(hit.getRefractedRay(), room, depth - 1);
    return color;
}

}  // namespace

Radiance embreesPicture(int size) {
    return pictureOf(size, [room = std::make_shared<EmbreeRoom>(loadRoom())](const Ray& ray) {
        return traceRay(ray, *room, labDepth);
    });
}

}  // namespace bench
