#include "app/terminal.h"

#ifdef _WIN32
#include <io.h>
#include <stdio.h>

#include "files/windowsApi.h"
#else
#include <sys/ioctl.h>
#include <unistd.h>
#endif

namespace {

constexpr int usualWidth = 80;

}  // namespace

#ifdef _WIN32

bool stderrIsTerminal() {
    return _isatty(_fileno(stderr)) != 0;
}

int terminalWidth() {
    CONSOLE_SCREEN_BUFFER_INFO info;
    if (!GetConsoleScreenBufferInfo(GetStdHandle(STD_ERROR_HANDLE), &info)) return usualWidth;
    return info.srWindow.Right - info.srWindow.Left + 1;
}

#else

bool stderrIsTerminal() {
    return isatty(STDERR_FILENO) != 0;
}

int terminalWidth() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usualWidth;
    return size.ws_col;
}

#endif
