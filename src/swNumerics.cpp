#include "swNumerics.h"

namespace sw::num {
namespace {

// The float nearest to x among those on the far side of it, in the direction of `towards`.
float roundTowards(double x, float towards) {
    const float rounded = static_cast<float>(x);
    if (towards > 0 && rounded < x) return std::nextafter(rounded, HUGE_VALF);
    if (towards < 0 && rounded > x) return std::nextafter(rounded, -HUGE_VALF);
    return rounded;
}

}  // namespace

float statedOrDefaultError(const Intersection& hit) {
    if (hit.positionError >= 0) return hit.positionError;
    return 0x1p-14f * (maxAbs(hit.position) + std::fabs(hit.hitT) * hit.ray.dir.norm());
}

Vec3 offsetFromSurface(const Vec3& point, const Vec3& normal, float distance) {
    const glm::dvec3 moved = toDouble(point) + static_cast<double>(distance) * toDouble(normal);
    return {roundTowards(moved.x, normal[0]), roundTowards(moved.y, normal[1]),
            roundTowards(moved.z, normal[2])};
}

}  // namespace sw::num
