#include "app/childProcess.h"
#include "app/programRun.h"
#include "support.h"

#if defined(__linux__)

using namespace test;

namespace {

// The least address space in which the system loads the program, in KiB; 0: a sanitizer needs all.
rlim_t leastSpace(const TemporaryFolder& folder) {
    const auto code = [&](rlim_t space) {
        return ChildProcess(folder, {"--version"}, space).wait().code;
    };
    if (code(2'000'000) != 0) return 0;
    constexpr int notLoaded = 127;
    rlim_t least = 1000;
    while (code(least) != 0) least += 500;
    while (code(least - 8) != notLoaded) least -= 8;
    return least;
}

}  // namespace

// Before main(), in static objects of libraries, and in it.
TEST_CASE("where memory ends before the program has begun, one line says so") {
    const TemporaryFolder folder;
    const rlim_t least = leastSpace(folder);
    for (rlim_t space = least; least > 0 && space < least + 400; space += 8) {
        const Ending end = ChildProcess(folder, {"--pixel", "1,1", "--quiet"}, space).wait();
        CAPTURE(least, space, end.code, end.signal, end.err);
        if (end.code == 127) continue;  // as addresses are random
        CHECK((end.code == 0 || end.code == 2));
        CHECK(lines(end.err) == (end.code == 2));
    }
}

// Address space is limited more and more tightly: a run that does not get what it needs says so.
// .ci runs no finer sweep than this; by hand, one in steps of 100 KiB.
TEST_CASE("where memory ends, at any step, one line says so and nothing crashes") {
    const TemporaryFolder folder;
    const rlim_t least = leastSpace(folder) + 100;
    if (least == 100) return;

    const auto words = GENERATE(
        std::vector<std::string>{"--size", "700x700", "--samples", "1", "--threads", "1"},
        std::vector<std::string>{"--size", "400x400", "--samples", "1", "--threads", "5"},
        std::vector<std::string>{"--size", "300x300", "--time-limit", "0.02", "--threads", "2"},
        std::vector<std::string>{"--size", "300x300", "--adaptive", "0.1", "--preview"});
    int done = 0, refused = 0;
    for (rlim_t space = least; done < 5 && space < 500'000; space += 700) {
        const Ending end = ChildProcess(folder, words, space).wait();
        CAPTURE(words, space, end.code, end.signal, end.err);
        CHECK((end.code == 0 || end.code == 2));
        if (end.code == 2) CHECK(lines(end.err) == 1);
        done += end.code == 0;
        refused += end.code == 2;
        CHECK(folder.count() == (done > 0));
    }
    CHECK(done == 5);
    CHECK(refused > 0);
}

#endif
