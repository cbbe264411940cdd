#include "files/temporary.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "files/failure.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#else
#include <signal.h>
#include <unistd.h>
#endif

namespace sw {
namespace {

namespace fs = std::filesystem;
using Name = fs::path::string_type;  // wide characters on Windows

long processId() {
#ifdef _WIN32
    return _getpid();
#else
    return getpid();
#endif
}

// An empty file, unless there is one by that name: false, and errno.
bool makeNew(const fs::path& path) {
#ifdef _WIN32  // where not every C library knows fopen's "x"
    const int file =
        _wopen(path.c_str(), _O_CREAT | _O_EXCL | _O_WRONLY | _O_BINARY, _S_IREAD | _S_IWRITE);
    return file >= 0 && _close(file) == 0;
#else
    std::FILE* const file = std::fopen(path.c_str(), "wbx");
    return file && std::fclose(file) == 0;
#endif
}

bool mayRun([[maybe_unused]] long process) {
#ifdef _WIN32
    return true;
#else
    return kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
#endif
}

// How the names of all temporary files for a target begin. A long name is cut, between two
// characters: file systems limit names to 255 bytes.
Name prefixFor(const fs::path& target) {
    constexpr std::size_t most = 150;
    Name name = target.filename().native();
    std::size_t end = std::min(most, name.size());
    while (end > 0 && end < name.size() && (name[end] & 0xC0) == 0x80) --end;
    return fs::path(".").concat(name.substr(0, end)).concat(".swtracer-").native();
}

fs::path temporaryFor(const fs::path& target) {
    fs::path name(prefixFor(target));
    name += std::to_string(processId()) + "-" + std::to_string(std::random_device()()) + ".tmp";
    return target.parent_path() / name;
}

// Reads digits of a name from `at` on; nothing if there are none, or too many.
std::optional<long> readNumber(const Name& name, std::size_t& at) {
    const std::size_t start = at;
    long number = 0;
    while (at < name.size() && at < start + 10 && name[at] >= '0' && name[at] <= '9')
        number = (number * 10 + (name[at++] - '0')) & 0x7fffffff;
    if (at == start) return std::nullopt;
    return number;
}

// The process that made a file, if its name is one of temporaryFor(); else nothing.
std::optional<long> makerOf(const Name& name, const Name& prefix) {
    if (name.compare(0, prefix.size(), prefix) != 0) return std::nullopt;
    std::size_t at = prefix.size();
    const auto process = readNumber(name, at);
    if (!process || *process == 0 || at == name.size() || name[at++] != '-') return std::nullopt;
    if (!readNumber(name, at) || name.substr(at) != fs::path(".tmp").native()) return std::nullopt;
    return process;
}

bool isOld(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    return !error && fs::file_time_type::clock::now() - time > std::chrono::hours(24);
}

}  // namespace

Temporary::Temporary(const fs::path& target, const fs::path& named) : path(temporaryFor(target)) {
    errno = 0;
    if (!makeNew(path)) failToWrite(named, reasonOf(errno));
}

Temporary::~Temporary() {
    std::error_code none;
    fs::remove(path, none);
}

void removeStale(const fs::path& target) {
    const Name prefix = prefixFor(target);
    std::error_code error;
    std::vector<fs::path> stale;
    for (fs::directory_iterator file(target.parent_path(), error), end; !error && file != end;
         file.increment(error)) {
        const auto maker = makerOf(file->path().filename().native(), prefix);
        if (maker && (!mayRun(*maker) || isOld(file->path()))) stale.push_back(file->path());
    }
    for (const fs::path& file : stale)
        if (fs::is_regular_file(fs::symlink_status(file, error))) fs::remove(file, error);
}

}  // namespace sw
