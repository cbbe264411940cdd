#include "swNumerics.h"

#include <bit>
#include <cstdint>

namespace sw::num {
namespace {

// The neighbouring float of x in the direction of `towards`: floats of one sign are ordered like
// their bits. Unlike std::nextafter it leaves 0 as it is, and is inlined.
float neighbour(float x, float towards) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    const bool grows = (x > 0) == (towards > 0);
    return x == 0 || towards == 0 ? x : std::bit_cast<float>(bits + (grows ? 1 : -1));
}

// x as a float, one step further so that rounding cannot undo the move.
float roundTowards(double x, float towards) {
    return neighbour(static_cast<float>(x), towards);
}

}  // namespace

Vec3 offsetFromSurface(const Vec3& point, const Vec3& normal, float distance) {
    const glm::dvec3 moved = toDouble(point) + static_cast<double>(distance) * toDouble(normal);
    return {roundTowards(moved.x, normal[0]), roundTowards(moved.y, normal[1]),
            roundTowards(moved.z, normal[2])};
}

}  // namespace sw::num
