#include "swRayCount.h"

#include <utility>

namespace sw {
namespace {

// One count per thread: shared ones would make the threads wait for each other.
constinit thread_local RayCount count;

}  // namespace

void countRay(RayKind kind, bool hit) {
    ++count.rays[static_cast<std::size_t>(kind)];
    if (hit && kind == RayKind::primary) ++count.primaryHits;
}

void leaveOut(LeftOut why, int rays) {
    count.leftOut[static_cast<std::size_t>(why)] += static_cast<std::uint64_t>(rays);
}

RayCount takeRayCount() {
    return std::exchange(count, RayCount());
}

}  // namespace sw
