#include <embree3/rtcore.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "tools/bench/yardstick.h"

namespace bench {
namespace {

class Embree : public Yardstick {
public:
    explicit Embree(const Model& source)
        : model(source), device(rtcNewDevice("threads=1,set_affinity=0")) {
        if (!device) throw std::runtime_error("Embree does not start");
        rtcSetDeviceMemoryMonitorFunction(device, count, &memory);
    }
    ~Embree() override {
        if (scene) rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    void build() override {
        if (scene) rtcReleaseScene(scene);
        scene = rtcNewScene(device);
        const RTCGeometry geometry = model.balls.empty() ? mesh() : spheres();
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }

    std::size_t trace(std::span<const sw::Ray> rays, bool any) const override {
        return any ? traceAny(rays) : traceClosest(rays);
    }

    std::size_t bytes() const override { return static_cast<std::size_t>(memory.load()); }

private:
    static bool count(void* total, ssize_t bytes, bool) {
        *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
        return true;
    }

    RTCGeometry mesh() const {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, model.vertices);
        fill(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, model.triangles);
        return geometry;
    }
    RTCGeometry spheres() const {
        const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, model.balls);
        return geometry;
    }
    template <typename Item>
    static void fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                     const std::vector<Item>& items) {
        void* buffer =
            rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
        std::memcpy(buffer, static_cast<const void*>(items.data()), items.size() * sizeof(Item));
    }

    static RTCRay convert(const sw::Ray& ray) {
        RTCRay r;
        r.org_x = ray.orig[0], r.org_y = ray.orig[1], r.org_z = ray.orig[2];
        r.dir_x = ray.dir[0], r.dir_y = ray.dir[1], r.dir_z = ray.dir[2];
        r.tnear = ray.minT, r.tfar = ray.maxT;
        r.time = 0;
        r.mask = ~0u;
        r.id = r.flags = 0;
        return r;
    }

    std::size_t traceClosest(std::span<const sw::Ray> rays) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (const sw::Ray& ray : rays) {
            RTCRayHit query;
            query.ray = convert(ray);
            query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene, &context, &query);
            hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        return hits;
    }

    std::size_t traceAny(std::span<const sw::Ray> rays) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (const sw::Ray& ray : rays) {
            RTCRay query = convert(ray);
            rtcOccluded1(scene, &context, &query);
            hits += query.tfar < 0;
        }
        return hits;
    }

    std::atomic<std::ptrdiff_t> memory{0};
    const Model& model;
    RTCDevice device;
    RTCScene scene = nullptr;
};

}  // namespace

std::unique_ptr<Yardstick> makeYardstick(const Model& model) {
    return std::make_unique<Embree>(model);
}

}  // namespace bench
