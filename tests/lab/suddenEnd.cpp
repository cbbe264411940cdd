#include "lab/suddenEnd.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

#include "tools/common/mainFunctions.h"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace lab {

void (*beforeSuddenEnd)() = nullptr;

namespace {

// No std::string: a signal handler reads it.
char noteFile[4096];
const char** runningFunction = nullptr;  // of the thread that runs the tests
std::atomic<bool> inTest{false};

// "KIND\nDETAIL\nFUNCTION": what happened, more about it, and which function of the student ran.
void note(const char* kind, const char* detail) {
    std::FILE* const file = std::fopen(noteFile, "wb");
    if (!file) return;
    std::fprintf(file, "%s\n%s\n%s", kind, detail,
                 runningFunction && *runningFunction ? *runningFunction : "");
    std::fclose(file);
}

[[noreturn]] void end(const char* kind, const char* sentence) {
    inTest = false;
    note(kind, "");
    std::fprintf(stderr, "\nlab: %s\n", sentence);
    if (beforeSuddenEnd) beforeSuddenEnd();
    std::fflush(nullptr);
    std::_Exit(1);
}

void atExit() {
    if (inTest) end("exit", "the program called exit() inside this test");
}

// Waits for the end of a test case, but not for ever.
class Watchdog {
public:
    Watchdog() : thread([this] { wait(); }) { thread.detach(); }

    void start(double seconds) {
        const std::lock_guard lock(mutex);
        limit = seconds;
        deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(seconds));
        changed.notify_one();
    }
    void stop() { start(1e6); }

private:
    using Clock = std::chrono::steady_clock;

    void wait() {
        std::unique_lock lock(mutex);
        for (;;) {
            const auto until = deadline;
            if (changed.wait_until(lock, until) == std::cv_status::timeout && until == deadline)
                break;
        }
        char sentence[100];
        std::snprintf(sentence, sizeof sentence, "this test was stopped after %g s", limit);
        end("time", sentence);
    }

    std::mutex mutex;
    std::condition_variable changed;
    double limit = 0;
    Clock::time_point deadline = Clock::now() + std::chrono::hours(24);
    std::thread thread;
};

Watchdog& watchdog() {
    static Watchdog* const dog = new Watchdog;  // never destroyed: its thread waits in it
    return *dog;
}

// Whether the main thread's stack has grown to its limit. Linux tells; elsewhere nobody knows.
bool stackIsFull() {
#ifdef __linux__
    static char maps[1 << 18];
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
    const int file = open("/proc/self/maps", O_RDONLY | O_CLOEXEC);
    std::size_t size = 0;
    for (ssize_t got = 1; file >= 0 && got > 0 && size + 1 < sizeof maps; size += std::size_t(got))
        if ((got = read(file, maps + size, sizeof maps - 1 - size)) <= 0) break;
    if (file >= 0) close(file);
    maps[size] = '\0';
    char* line = std::strstr(maps, "[stack]");
    while (line && line > maps && line[-1] != '\n') --line;
    std::uintmax_t low = 0, high = 0;
    if (!line || std::sscanf(line, "%jx-%jx", &low, &high) != 2) return false;
    return high - low >= limit.rlim_cur / 10 * 9;
#else
    return false;
#endif
}

// This process is in no state to make the report.
void reportFromOutside() {
#ifndef _WIN32
    const pid_t child = fork();
    if (child == 0) {
        execl(SW_LAB_REPORT, SW_LAB_REPORT, "page", SW_LAB_RECORDS, SW_LAB_TESTS, SW_LAB_PAGE,
              static_cast<char*>(nullptr));
        _exit(1);
    }
    if (child > 0) waitpid(child, nullptr, 0);
#endif
}

}  // namespace

void expectSuddenEnd(const std::filesystem::path& file, double seconds) {
    static const int registered = std::atexit(atExit);
    static_cast<void>(registered);
    std::error_code none;
    std::filesystem::remove(file, none);
    std::snprintf(noteFile, sizeof noteFile, "%s", file.string().c_str());
    runningFunction = &studentFunction;
    inTest = true;
    watchdog().start(seconds);
}

void expectNoSuddenEnd() {
    inTest = false;
    watchdog().stop();
}

void noteSignal(const char* name) {
    inTest = false;
    const bool full = stackIsFull();
    note(full ? "recursion" : "signal", name);
    if (full)
        std::fprintf(stderr, "\nlab: the stack is full: a function calls itself without end\n");
    reportFromOutside();
}

}  // namespace lab
