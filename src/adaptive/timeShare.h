#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "swRenderer.h"

namespace sw {

using Clock = std::chrono::steady_clock;

/// How long a sweep over pixels may take, and a single pixel in it. By default, there is no limit.
/// A pixel whose rays double at every level can take for ever: it is given up when it has used its
/// share. What such pixels take together is limited as well, so that the others get their turn.
class TimeShare {
public:
    /// @param stop  asked as well; may be empty, must outlive this
    explicit TimeShare(const StopQuestion& stop) : stop(stop) {}
    /// @param end   of the sweep
    /// @param pool  what the pixels that are given up may take together, in seconds of a thread
    TimeShare(const StopQuestion& stop, Clock::time_point end, double pool)
        : stop(stop),
          end(end),
          pool(std::chrono::nanoseconds(static_cast<long long>(1e9 * pool))) {}

    bool isLimited() const { return end != Clock::time_point::max(); }
    bool isNeeded() const { return isLimited() || stop; }
    /// Whether the sweep is to end. Once it is, it stays so.
    bool isOver(Clock::time_point now, int x, int y) {
        if (now >= end || (stop && stop(x, y))) over = true;
        return over;
    }
    bool wasOver() const { return over; }
    /// What a pixel may take.
    std::chrono::nanoseconds perPixel() const {
        if (!isLimited()) return std::chrono::nanoseconds::max();
        return std::max(pool.load() / 64, std::chrono::nanoseconds(50'000));
    }
    void giveUp(std::chrono::nanoseconds spent) {
        pool = std::max(pool.load() - spent, std::chrono::nanoseconds(0));
        wasted.fetch_add(spent.count());
    }
    /// What the pixels that were given up took together, in seconds of a thread.
    double secondsWasted() const { return 1e-9 * static_cast<double>(wasted); }

private:
    const StopQuestion& stop;
    std::atomic<bool> over{false};
    const Clock::time_point end = Clock::time_point::max();
    std::atomic<std::chrono::nanoseconds> pool{std::chrono::nanoseconds::max()};
    std::atomic<long long> wasted{0};  // nanoseconds
};

/// One thread's part of a sweep.
class PixelTimer {
public:
    explicit PixelTimer(TimeShare& share) : share(share) {}

    /// Whether the sweep is over.
    bool isOver() const { return over; }

    /// Whether to stop: with the sweep, or with this pixel.
    bool operator()(int nowX, int nowY) {
        const auto now = Clock::now();
        over = over || share.isOver(now, nowX, nowY);
        if (over) return true;
        if (nowX != x || nowY != y || !begun) {
            x = nowX;
            y = nowY;
            begun = true;
            since = now;
            return false;
        }
        const bool tooLong = !ShortRays::areOn() && now - since > share.perPixel();
        if (tooLong) share.giveUp(now - since);
        return tooLong;
    }

private:
    TimeShare& share;
    Clock::time_point since;
    int x = 0, y = 0;
    bool begun = false;
    bool over = false;
};

/// Calls pixel(x, y) for an area, row by row, until the time is up. A call that takes longer than
/// its share is broken off, and made again with ShortRays.
/// @param pixel      calls checkStop() first
/// @param takesLong  whether to make no attempt with long rays
template <typename Pixel, typename TakesLong>
void visit(const Window& area, TimeShare& share, const Pixel& pixel, const TakesLong& takesLong) {
    PixelTimer timer(share);
    const StopQuestion question = share.isNeeded() ? StopQuestion(std::ref(timer)) : nullptr;
    const StopScope scope(question);
    const auto succeeds = [&](int x, int y) {
        try {
            pixel(x, y);
            return true;
        } catch (const Stopped&) {
            return false;
        }
    };
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x) {
            if (!takesLong(x, y) && succeeds(x, y)) continue;
            const ShortRays cut;
            if (timer.isOver() || !succeeds(x, y)) return;
        }
    }
}

}  // namespace sw
