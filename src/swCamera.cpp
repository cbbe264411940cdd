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

// The coordinate axis most nearly at right angles to v.
dvec3 leastAlignedAxis(const dvec3& v) {
    const dvec3 a = abs(v);
    if (a.y <= a.x && a.y <= a.z) return {0, 1, 0};
    return a.x <= a.z ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
}

// To the right of the view. If cross(view, up) is shorter than 2^-20, its direction is noise: the
// rounding errors of the float coordinates.
dvec3 rightOf(const dvec3& view, const dvec3& up) {
    const dvec3 right = cross(view, up);
    if (glm::length(right) > 0x1p-20) return glm::normalize(right);
    return glm::normalize(cross(view, leastAlignedAxis(view)));
}

}  // namespace

Camera::Camera(const Vec3& origin, const Vec3& lookAt, const Vec3& up, float fov, float aspect)
    : origin(origin), halfHeight(std::tan(fov * (std::acos(-1.0) / 360))), columns(aspect) {
    const dvec3 view = num::unitOr(num::toDouble(lookAt) - num::toDouble(origin), {0, 0, -1});
    const dvec3 right = rightOf(view, num::unitOr(num::toDouble(up), {0, 0, 0}));
    store(forward, view);
    store(rightward, right);
    store(upward, cross(right, view));
}

void Camera::setup(int width, int height) {
    columns = width;
    rows = height;
}

Ray Camera::getRay(float x, float y) const {
    const double pixel = 2 * halfHeight / rows;
    const double right = (x - columns / 2) * pixel;
    const double up = (rows / 2 - y) * pixel;
    const dvec3 direction = load(forward) + right * load(rightward) + up * load(upward);
    return Ray(origin, num::toFloat(glm::normalize(direction)), 0, FLT_MAX, RayKind::primary);
}

}  // namespace sw
