#include "app/progressBar.h"

#include <chrono>
#include <cstdio>
#include <iomanip>
#include <iostream>

#include "nff/plainText.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* clearLine = "\r\x1b[K";

bool stderrIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

void drawBar(int done, int total, double seconds) {
    constexpr int width = 40;
    std::ostringstream line = sw::plainStream();
    line << "\r[" << std::string(static_cast<std::size_t>(done * width / total), '#')
         << std::string(static_cast<std::size_t>(width - done * width / total), ' ') << "] "
         << std::setw(3) << done * 100 / total << " %  " << std::fixed << std::setprecision(1)
         << seconds * (total - done) / done << " s left ";
    std::cerr << line.str() << std::flush;
}

}  // namespace

std::function<void(int done, int total)> makeProgressBar(bool quiet) {
    if (quiet || !stderrIsTerminal()) return nullptr;
    const auto start = Clock::now();
    return [start, drawn = start](int done, int total) mutable {
        const auto now = Clock::now();
        const bool visible = drawn != start;
        if (done == total) {
            if (visible) std::cerr << clearLine << std::flush;
        } else if (now - drawn > std::chrono::milliseconds(100)) {
            drawn = now;
            drawBar(done, total, std::chrono::duration<double>(now - start).count());
        }
    };
}
