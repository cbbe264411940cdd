#include "swStop.h"

#include <bit>
#include <cfloat>
#include <cstdint>
#include <limits>

namespace sw {
namespace {

constexpr int checksBetween = 64;  // so that a clock may be read without being noticed

// Short rays carry their generation in maxT: the n-th float below FLT_MAX for the n-th generation.
// No hit is as far as that, and other rays need no room for it.
constexpr auto longest = std::bit_cast<std::uint32_t>(FLT_MAX);

std::uint32_t generationOf(const Ray& ray) {
    constexpr std::uint32_t most = 30;
    const std::uint32_t n = longest - std::bit_cast<std::uint32_t>(ray.maxT);
    return n <= most ? n : 0;
}

}  // namespace

void askToStop() {
    stopState.checks = stopState.question ? checksBetween : std::numeric_limits<int>::max();
    if (stopState.cutsRays) stopState.checks = 0;  // every ray is looked at
    if (stopState.question && (*stopState.question)(stopState.x, stopState.y)) throw Stopped();
}

void stopOrCut(const Ray& from, Ray& spawned) {
    if (!stopState.cutsRays) return askToStop();
    if (++stopState.shortRays % checksBetween == 0) askToStop();
    stopState.checks = 0;
    const std::uint32_t generation = generationOf(from) + 1;
    const bool isCut = generation > ShortRays::generations;
    spawned.maxT = isCut ? -1 : std::bit_cast<float>(longest - generation);
}

}  // namespace sw
