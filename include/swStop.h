#pragma once

#include <functional>
#include <utility>

#include "swRay.h"

namespace sw {

/// Thrown where a rendering is to stop: from checkStop(), through the functions that compute a
/// pixel, to what renders it.
struct Stopped {};

/// Whether to stop now. Asked by any thread, with the pixel that is in work.
using StopQuestion = std::function<bool(int x, int y)>;

/// This thread's question, if there is one, its pixel, and the checks until it is asked again.
struct StopState {
    const StopQuestion* question = nullptr;
    int x = 0, y = 0;
    int checks = 0;
    bool cutsRays = false;
    unsigned shortRays = 0;  ///< that it has met
};
inline thread_local constinit StopState stopState;

/// During its lifetime, this thread's checks ask a question.
class StopScope {
public:
    /// @param question  empty: the checks do nothing
    explicit StopScope(const StopQuestion& question)
        : outer(std::exchange(stopState, StopState{question ? &question : nullptr})) {}
    ~StopScope() { stopState = outer; }
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

private:
    const StopState outer;
};

/// During its lifetime, this thread's rays end after a few reflections and refractions.
class ShortRays {
public:
    static constexpr int generations = 6;
    ShortRays() { set(true); }
    ~ShortRays() { set(false); }
    ShortRays(const ShortRays&) = delete;
    ShortRays& operator=(const ShortRays&) = delete;

    static bool areOn() { return stopState.cutsRays; }

private:
    static void set(bool on) {
        stopState.cutsRays = on;
        stopState.checks = 0;
    }
};

/// Asks the question.
/// @throws Stopped if the answer is yes
void askToStop();

/// To be called before every pixel: once in a while, it asks the question.
/// @param samples  of the pixel; each counts as a ray
/// @throws Stopped
inline void checkStop(int x, int y, int samples) {
    constexpr int least = 8;
    stopState.x = x;
    stopState.y = y;
    stopState.checks -= samples > least ? samples : least;
    if (stopState.checks < 0) askToStop();
}

void stopOrCut(const Ray& from, Ray& spawned);

/// To be called for every reflected or refracted ray, as they may double at every level.
/// @param from     the ray that was reflected or refracted
/// @param spawned  where rays are short, it may be changed into one that hits nothing
/// @throws Stopped
inline void checkStop(const Ray& from, Ray& spawned) {
    if (--stopState.checks < 0) [[unlikely]]
        stopOrCut(from, spawned);
}

}  // namespace sw
