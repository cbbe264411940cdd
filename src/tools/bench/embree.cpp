#include <atomic>
#include <cstring>
#include <stdexcept>

#include "tools/bench/embreeRays.h"
#include "tools/bench/yardstick.h"

namespace bench {
namespace {

class Embree : public Yardstick {
public:
    Embree(const Model& source, bool watertight)
        : model(source),
          flags(watertight ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE),
          device(startEmbree()) {
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
        rtcSetSceneFlags(scene, flags);
        const RTCGeometry geometry = model.balls.empty() ? mesh() : spheres();
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
    }

    std::size_t trace(std::span<const sw::Ray> rays, bool any) const override {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (const sw::Ray& ray : rays)
            hits += any ? isOccluded(scene, context, ray)
                        : nearestHit(scene, context, ray).hit.geomID != RTC_INVALID_GEOMETRY_ID;
        return hits;
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

    std::atomic<std::ptrdiff_t> memory{0};
    const Model& model;
    RTCSceneFlags flags;
    RTCDevice device;
    RTCScene scene = nullptr;
};

}  // namespace

RTCDevice startEmbree() {
    const RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
    if (!device) throw std::runtime_error("Embree does not start");
    return device;
}

std::unique_ptr<Yardstick> makeYardstick(const Model& model, bool watertight) {
    return std::make_unique<Embree>(model, watertight);
}

}  // namespace bench
