#pragma once

#include <cfloat>
#include <cmath>

#include "swMaterial.h"
#include "swSampling.h"
#include "tools/bench/picture.h"

/// Ray tracing as on the slides, in float and with an epsilon, to compare ours with.
namespace bench::textbook {

using sw::Material;
using sw::Vec3;

constexpr float epsilon = 0.01f;

inline float norm(const Vec3& v) {
    return std::sqrt(v * v);
}
inline Vec3 normalized(const Vec3& v) {
    return v * (1 / norm(v));
}

struct Ray {
    Vec3 orig, dir;
    float minT = epsilon, maxT = FLT_MAX;
};

struct Hit {
    Vec3 position, normal;
    float hitT = FLT_MAX;
    bool frontFacing = true;
    Material material;
    Ray ray;

    Ray getShadowRay(const Vec3& light) const {
        const Vec3 way = light - position;
        const float distance = norm(way);
        return {position, way * (1 / distance), epsilon, distance - epsilon};
    }
    Ray getReflectedRay() const {
        return {position, normalized(ray.dir - 2 * (ray.dir * normal) * normal)};
    }
    Ray getRefractedRay() const {
        const float eta = frontFacing ? 1 / material.refractiveIndex : material.refractiveIndex;
        const float r = -(ray.dir * normal);
        const float c = 1 - eta * eta * (1 - r * r);
        if (c < 0) return getReflectedRay();
        return {position, normalized(eta * ray.dir + (eta * r - std::sqrt(c)) * normal)};
    }
};

/// The lab's camera at its place in the lab scene.
class Camera {
public:
    explicit Camera(int size)
        : scale(2 * std::tan(26 * 3.14159265f / 180) / static_cast<float>(size)),
          middle(static_cast<float>(size) / 2) {}

    Ray getRay(float x, float y) const {
        return {Vec3(0, 10, 30), normalized(Vec3((x - middle) * scale, (middle - y) * scale, -1))};
    }

private:
    float scale, middle;
};

/// The lab's picture, with jittered samples in every pixel.
/// @param trace  called as trace(ray): the colour that comes back along it
template <typename Trace>
Radiance pictureOf(int size, const Trace& trace) {
    return [trace, camera = Camera(size)](int x, int y) {
        constexpr float n = labSamples;
        Vec3 sum;
        for (float j = 0; j < n; ++j) {
            for (float i = 0; i < n; ++i) {
                const float dx = (i + sw::uniform()) / n, dy = (j + sw::uniform()) / n;
                sum += trace(camera.getRay(static_cast<float>(x) + dx, static_cast<float>(y) + dy));
            }
        }
        return sum * (1 / (n * n));
    };
}

}  // namespace bench::textbook
