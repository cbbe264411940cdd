#include "swNumerics.h"

#include <bit>
#include <cfloat>
#include <cstdint>

// The x87 keeps more digits than a float has until it happens to store one: bounds and edges leak.
static_assert(FLT_EVAL_METHOD == 0,
              "every float must be rounded: -msse2 -mfpmath=sse on 32-bit x86");

namespace sw::num {
namespace {

// The neighbouring float of x in the direction of `towards`: floats of one sign are ordered like
// their bits. Unlike std::nextafter it leaves 0 as it is, and is inlined.
float neighbour(float x, float towards) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    const bool grows = (x > 0) == (towards > 0);
    return x == 0 || towards == 0 ? x : std::bit_cast<float>(bits + (grows ? 1 : -1));
}

}  // namespace

Vec3 offsetFromSurface(const Vec3& point, const Vec3& normal, float distance) {
    const Vec3 moved = toFloat(toDouble(point) + static_cast<double>(distance) * toDouble(normal));
    return {neighbour(moved[0], normal[0]), neighbour(moved[1], normal[1]),
            neighbour(moved[2], normal[2])};  // further, so that rounding cannot undo the move
}

}  // namespace sw::num
