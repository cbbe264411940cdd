#include "files/stream.h"

#include <cerrno>

#include "files/failure.h"

#include <fcntl.h>
#ifdef _WIN32
#include <io.h>
#else
#include <poll.h>
#include <unistd.h>
#endif

namespace sw {
namespace {

namespace fs = std::filesystem;

#ifdef _WIN32

bool takesOutput(int stream) {
    return _get_osfhandle(stream) >= 0;
}

long long writeSome(int stream, std::string_view content) {
    _setmode(stream, _O_BINARY);
    return _write(stream, content.data(), static_cast<unsigned>(content.size()));
}

#else

bool takesOutput(int stream) {
    const int flags = fcntl(stream, F_GETFL);
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

// Waits where the stream would rather not: another program may have made a pipe non-blocking.
long long writeSome(int stream, std::string_view content) {
    const auto written = ::write(stream, content.data(), content.size());
    if (written >= 0 || (errno != EINTR && errno != EAGAIN)) return written;
    pollfd writable{.fd = stream, .events = POLLOUT, .revents = 0};
    poll(&writable, 1, -1);
    return 0;
}

#endif

}  // namespace

void requireOpen(int stream, const fs::path& name) {
    if (!takesOutput(stream)) failToWrite(name, "it is closed, or open for reading only");
}

void writeToStream(int stream, std::string_view content, const fs::path& name) {
    constexpr std::size_t part = 1 << 20;
    while (!content.empty()) {
        const auto written = writeSome(stream, content.substr(0, part));
        if (written < 0) failToWrite(name, reasonOf(errno));
        content.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace sw
