#include "app/process.h"

#ifdef _WIN32

#include "files/windowsApi.h"

namespace {

// What the program prints is UTF-8, as its arguments are. The console is not ours alone: it gets
// its code page back.
class Utf8Console {
public:
    Utf8Console() { SetConsoleOutputCP(CP_UTF8); }
    ~Utf8Console() {
        if (before != 0) SetConsoleOutputCP(before);
    }
    Utf8Console(const Utf8Console&) = delete;
    Utf8Console& operator=(const Utf8Console&) = delete;

private:
    const UINT before = GetConsoleOutputCP();  // 0: no console
};

}  // namespace

void prepareProcess() {
    static const Utf8Console console;
}

#else

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

namespace {

// Where memory does not even suffice for an exception, or one cannot be caught, there is a word.
[[noreturn]] void endWithoutMemory() {
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
    } catch (...) {
        std::abort();
    }
    constexpr std::string_view line = "swtracer: too little memory\n";
    _exit(write(STDERR_FILENO, line.data(), line.size()) < 0 ? 4 : 2);
}

// Static objects take memory as well: where that is possible, this comes before them.
#ifdef __linux__
[[gnu::constructor(101)]]
#endif
void expectLackOfMemory() {
    std::set_terminate(endWithoutMemory);
}

// A closed standard stream stays closed, instead of becoming the next file that is opened: open()
// takes the lowest number that is free.
void keepClosedStreams() {
    for (const int stream : {0, 1, 2}) {
        if (fcntl(stream, F_GETFD) >= 0) continue;
        const int unusable = stream == 0 ? O_WRONLY : O_RDONLY;
        if (open("/dev/null", unusable) < 0) break;
    }
}

}  // namespace

void prepareProcess() {
    expectLackOfMemory();
    keepClosedStreams();
    signal(SIGXFSZ, SIG_IGN);  // growing beyond the system's limit is an error, not the end
}

#endif
