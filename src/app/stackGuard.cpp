#include "app/stackGuard.h"

#if defined(__linux__) || defined(__APPLE__)

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace stackGuard {
namespace {

struct Thread {
    char* lowest = nullptr;  // address of the stack
    int x = 0, y = 0;
};
thread_local constinit Thread current;

// The lowest address of this thread's stack.
char* lowestAddress() {
#ifdef __APPLE__
    return static_cast<char*>(pthread_get_stackaddr_np(pthread_self())) -
           pthread_get_stacksize_np(pthread_self());
#else
    pthread_attr_t attributes;
    void* address = nullptr;
    std::size_t size = 0;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
    pthread_attr_getstack(&attributes, &address, &size);
    pthread_attr_destroy(&attributes);
    return static_cast<char*>(address);
#endif
}

// A frame may reach beyond the guard page at the stack's end, but not far.
void explain(int signal, siginfo_t* info, void*) {
    constexpr long near = 1 << 16;
    const long beyond = static_cast<char*>(info->si_addr) - current.lowest;
    if (current.lowest && beyond > -near && beyond < near) {
        char line[200];
        const int size = std::snprintf(
            line, sizeof line,
            "swtracer: the stack is full: does traceRay() call itself without end? Does the depth "
            "decrease with every call? Try --pixel %d,%d\n",
            current.x, current.y);
        if (write(STDERR_FILENO, line, static_cast<std::size_t>(size)) < 0) _exit(1);
        _exit(1);
    }
    ::signal(signal, SIG_DFL);  // any other fault takes its usual way
}

// The handler needs a stack of its own. It is the thread's from its start: an allocation could
// fail.
thread_local constinit char handlerStack[1 << 15] = {};

// A thread that has such a stack already, as sanitizers give it one, keeps that.
bool provideHandlerStack() {
    stack_t stack{};
    if (sigaltstack(nullptr, &stack) == 0 && (stack.ss_flags & SS_DISABLE) == 0) return true;
    stack = {};
    stack.ss_sp = handlerStack;
    stack.ss_size = sizeof handlerStack;
    return sigaltstack(&stack, nullptr) == 0;
}

bool installHandler() {
    struct sigaction action {};
    action.sa_sigaction = explain;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaction(SIGBUS, &action, nullptr);  // macOS
    return sigaction(SIGSEGV, &action, nullptr) == 0;
}

}  // namespace

void watch(int x, int y) {
    static const bool installed = installHandler();
    if (!current.lowest && installed && provideHandlerStack()) current.lowest = lowestAddress();
    current.x = x;
    current.y = y;
}

}  // namespace stackGuard

#else

void stackGuard::watch(int, int) {}

#endif
