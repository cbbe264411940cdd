#include "files/standardStream.h"

#include <algorithm>
#include <iterator>

#include "files/openFile.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace sw {
namespace {

std::FILE* openCopy(int stream) {
#ifdef _WIN32
    _setmode(stream, _O_BINARY);
    return _fdopen(_dup(stream), "rb");
#else
    return fdopen(dup(stream), "rb");
#endif
}

}  // namespace

std::optional<int> standardStream(const std::filesystem::path& path) {
    constexpr const char* names[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
    const auto name = std::find(std::begin(names), std::end(names), path.generic_string());
    if (name == std::end(names)) return std::nullopt;
    return static_cast<int>(name - names);
}

std::FILE* openToRead(const std::filesystem::path& path) {
    if (const auto stream = standardStream(path)) return openCopy(*stream);
    return openFile(path, "rb");
}

bool isDevice([[maybe_unused]] std::FILE* file) {
#ifdef _WIN32
    return false;
#else
    struct stat status {};
    return fstat(fileno(file), &status) == 0 && S_ISCHR(status.st_mode) && !isatty(fileno(file));
#endif
}

}  // namespace sw
