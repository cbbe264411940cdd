#include "swThreads.h"

#include <atomic>
#include <set>
#include <stdexcept>

#include "support.h"

using namespace sw;

TEST_CASE("work is done by as many threads as asked for, each once") {
    const auto count = GENERATE(1, 2, 7);
    std::mutex mutex;
    std::multiset<std::thread::id> ids;
    std::atomic<int> waiting = count;
    const int took = onThreads(count, [&] {
        --waiting;
        while (waiting > 0) std::this_thread::yield();
        const std::lock_guard lock(mutex);
        ids.insert(std::this_thread::get_id());
    });
    CHECK(took == count);
    CHECK(ids.size() == static_cast<std::size_t>(count));
    CHECK(ids.count(std::this_thread::get_id()) == 1);
}

TEST_CASE("an exception of any thread is passed on when all threads have ended") {
    const auto throwers = GENERATE(1, 2, 5);
    std::atomic<int> next{0}, ended{0};
    const auto work = [&] {
        if (next++ < throwers) throw std::domain_error("no");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++ended;
    };
    CHECK_THROWS_AS(onThreads(5, work), std::domain_error);
    CHECK(ended == 5 - throwers);
}
