#pragma once

// A program that is watched while it runs: POSIX only.

#ifndef _WIN32

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "catch.h"
#include "files.h"

namespace test {

/// How a child process has ended.
struct Ending {
    int code = -1;   ///< exit code; -1 if a signal ended it
    int signal = 0;  ///< that ended it
    std::string out, err;
};

/// The program swtracer in a folder, from its start to its end.
class ChildProcess {
public:
    /// @param addressSpace  in KiB; 0: no limit
    ChildProcess(const TemporaryFolder& folder, std::vector<std::string> arguments,
                 rlim_t addressSpace = 0) {
        std::string program = SW_PROGRAM;
        std::vector<char*> words{program.data()};
        for (std::string& argument : arguments) words.push_back(argument.data());
        words.push_back(nullptr);
        const std::string out = (printed / "out").string(), err = (printed / "err").string();
        process = fork();
        REQUIRE(process >= 0);
        if (process > 0) return;
        if (chdir(folder.path.c_str()) != 0) _exit(99);
        dup2(open(out.c_str(), O_CREAT | O_WRONLY, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_CREAT | O_WRONLY, 0600), STDERR_FILENO);
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        const rlimit none{0, 0}, space{addressSpace * 1024, addressSpace * 1024};
        setrlimit(RLIMIT_CORE, &none);
        if (addressSpace > 0) setrlimit(RLIMIT_AS, &space);
        execv(words[0], words.data());
        _exit(98);
    }
    ~ChildProcess() {
        if (process > 0) {
            kill(process, SIGKILL);
            waitpid(process, nullptr, 0);
        }
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    void send(int signal) const { kill(process, signal); }

    Ending wait() {
        int status = 0;
        waitpid(process, &status, 0);
        process = 0;
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                WIFSIGNALED(status) ? WTERMSIG(status) : 0, contentOf(printed / "out"),
                contentOf(printed / "err")};
    }

private:
    const TemporaryFolder printed;
    pid_t process = 0;
};

/// Waits until a condition holds, but not for ever.
template <typename Condition>
bool comesTrue(const Condition& condition, double seconds = 30) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (!condition()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

inline void pause(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace test

#endif
