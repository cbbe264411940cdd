#include "app/childProcess.h"
#include "app/programRun.h"
#include "support.h"

#if defined(__linux__)

using namespace test;

// Address space is limited more and more tightly: a run that does not get what it needs says so.
// .ci runs no finer sweep than this; by hand, one in steps of 100 KiB.
TEST_CASE("where memory ends, at any step, one line says so and nothing crashes") {
    const TemporaryFolder folder;
    if (ChildProcess(folder, {"--version"}, 2'000'000).wait().code != 0) return;  // a sanitizer
    rlim_t least = 1000;  // KiB: loads the program at all
    while (ChildProcess(folder, {"--version"}, least).wait().code != 0) least += 500;
    least += 500;  // the C++ library cannot throw before it has memory for that

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
