#include "app/stackGuard.h"

#include "support.h"

// Where the system tells of its stacks. A sanitizer has its own say about a full one.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#if defined(__has_feature)
#define SW_HAS_SANITIZER __has_feature(address_sanitizer)
#else
#define SW_HAS_SANITIZER 0
#endif
#if !SW_HAS_SANITIZER

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <string>
#include <thread>

namespace {

struct Ending {
    int status = 0;    // as waitpid() has it
    std::string said;  // on stderr
};

// What becomes of a process that does this.
template <typename Action>
Ending endingOf(const Action& action) {
    int pipeEnds[2];
    REQUIRE(pipe(pipeEnds) == 0);
    const pid_t child = fork();
    if (child == 0) {
        dup2(pipeEnds[1], STDERR_FILENO);
        const rlimit none{0, 0};
        setrlimit(RLIMIT_CORE, &none);
        std::signal(SIGSEGV, SIG_DFL);
        action();
        _exit(0);
    }
    close(pipeEnds[1]);
    Ending ending;
    std::array<char, 1000> text{};
    for (ssize_t size; (size = read(pipeEnds[0], text.data(), text.size())) > 0;)
        ending.said.append(text.data(), static_cast<std::size_t>(size));
    close(pipeEnds[0]);
    waitpid(child, &ending.status, 0);
    return ending;
}

// NOLINTNEXTLINE: has no end on purpose
int deeper(volatile int* number) {
    volatile int mine = *number + 1;
    return *number < 0 ? 0 : deeper(&mine) + mine;
}

void recurse() {
    stackGuard::watch(12, 34);
    volatile int zero = 0;
    deeper(&zero);
}

}  // namespace

TEST_CASE("a recursion without end is explained, in any thread") {
    const bool inThread = GENERATE(false, true);
    const Ending ending = endingOf([&] { inThread ? std::thread(recurse).join() : recurse(); });
    CAPTURE(inThread, ending.said);
    CHECK((WIFEXITED(ending.status) && WEXITSTATUS(ending.status) == 1));
    CHECK(ending.said.find("the stack is full") != std::string::npos);
    CHECK(ending.said.find("--pixel 12,34\n") != std::string::npos);
}

TEST_CASE("any other fault ends the program as usual") {
    const Ending ending = endingOf([] {
        stackGuard::watch(1, 2);
        volatile std::uintptr_t nowhere = 8;
        *reinterpret_cast<volatile int*>(nowhere) = 1;  // NOLINT
    });
    CHECK((WIFSIGNALED(ending.status) && WTERMSIG(ending.status) == SIGSEGV));
    CHECK(ending.said.empty());
}

#endif
#endif
