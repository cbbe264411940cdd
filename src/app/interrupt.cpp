#include "app/interrupt.h"

#include <atomic>

namespace {

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may write it");

extern "C" void note(int signal) {
    noted = signal;
    std::signal(signal, SIG_DFL);
}

using Handler = void (*)(int);

Handler install(int signal) {
    const Handler before = std::signal(signal, note);
    if (before == SIG_IGN) std::signal(signal, SIG_IGN);
    return before == SIG_ERR ? SIG_DFL : before;
}

// Whoever has sent one signal may still want to end the program by another.
void restore(int signal, Handler before) {
    if (before != note) std::signal(signal, before);
}

}  // namespace

InterruptNotice::InterruptNotice()
    : ofInterrupt(install(SIGINT)), ofTermination(install(SIGTERM)) {}

InterruptNotice::~InterruptNotice() {
    restore(SIGINT, ofInterrupt);
    restore(SIGTERM, ofTermination);
}

int InterruptNotice::signal() {
    return noted;
}
