#pragma once

#include <csignal>

/// During its lifetime, SIGINT (Ctrl-C) and SIGTERM are noted. A second one ends the program at
/// once, as it would have without this. A signal that was ignored before stays so.
class InterruptNotice {
public:
    InterruptNotice();
    ~InterruptNotice();
    InterruptNotice(const InterruptNotice&) = delete;
    InterruptNotice& operator=(const InterruptNotice&) = delete;

    /// The signal that has come since the program began; 0: none.
    static int signal();

private:
    using Handler = void (*)(int);
    Handler ofInterrupt, ofTermination;  // those before
};
