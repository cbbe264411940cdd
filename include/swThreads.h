#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sw {

/// Calls work() on `count` threads at once, the calling one among them, and waits for all. Where
/// the system grants fewer threads, or no memory for them, those that run will do. The first
/// exception of work() is passed on. Returns how many threads took part.
template <typename Work>
int onThreads(int count, const Work& work) {
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            work();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    };
    std::vector<std::thread> helpers;
    try {
        // Reserved: a vector that fails to grow would destroy threads that run.
        helpers.reserve(static_cast<std::size_t>(count));
        for (int i = 1; i < count; ++i) helpers.emplace_back(run);
    } catch (const std::exception&) {
    }
    run();
    for (std::thread& helper : helpers) helper.join();
    if (failure) std::rethrow_exception(failure);
    return static_cast<int>(helpers.size()) + 1;
}

}  // namespace sw
