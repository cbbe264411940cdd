#include "swCamera.h"

#include "swNumerics.h"

namespace sw {
namespace {

using glm::dvec3;

void store(double (&target)[3], const dvec3& v) {
    target[0] = v.x;
    target[1] = v.y;
    target[2] = v.z;
}

dvec3 load(const double (&source)[3]) {
    return {source[0], source[1], source[2]};
}

dvec3 unitOr(const dvec3& v, const dvec3& fallback) {
    const double length = glm::length(v);
    return length > 0 ? v / length : fallback;
}

// The coordinate axis most nearly at right angles to v.
dvec3 leastAlignedAxis(const dvec3& v) {
    const dvec3 a = abs(v);
    if (a.y <= a.x && a.y <= a.z) return {0, 1, 0};
    return a.x <= a.z ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
}

// To the right of the view. Below 2^-20 the direction of cross(view, up) is that of the float
// coordinates' rounding errors.
dvec3 rightOf(const dvec3& view, const dvec3& up) {
    const dvec3 right = cross(view, up);
    if (glm::length(right) > 0x1p-20) return glm::normalize(right);
    return glm::normalize(cross(view, leastAlignedAxis(view)));
}

}  // namespace

Camera::Camera(const Vec3& origin, const Vec3& lookAt, const Vec3& upwards, float fov, float aspect)
    : eye(origin), halfHeight(std::tan(fov * (std::acos(-1.0) / 360))), width(aspect) {
    const dvec3 view = unitOr(num::toDouble(lookAt) - num::toDouble(origin), {0, 0, -1});
    const dvec3 sideways = rightOf(view, unitOr(num::toDouble(upwards), {0, 0, 0}));
    store(forward, view);
    store(right, sideways);
    store(up, cross(sideways, view));
}

void Camera::setup(int pixelsAcross, int pixelsDown) {
    width = pixelsAcross;
    height = pixelsDown;
}

Ray Camera::getRay(float x, float y) const {
    const double pixel = 2 * halfHeight / height;
    const double across = (x - width / 2) * pixel;
    const double upwards = (height / 2 - y) * pixel;
    const dvec3 direction = load(forward) + across * load(right) + upwards * load(up);
    return Ray(eye, num::toFloat(glm::normalize(direction)), 0, FLT_MAX, RayKind::primary);
}

}  // namespace sw
