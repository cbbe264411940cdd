#include "files/target.h"

#include <charconv>
#include <system_error>

#include "files/failure.h"
#include "files/standardStream.h"
#include "swFile.h"

#ifdef _WIN32
#include <wchar.h>
#else
#include <unistd.h>
#endif

namespace sw {
namespace {

namespace fs = std::filesystem;

// The stream that /dev/fd/7 or /proc/<this process>/fd/7 stands for. The folder is canonical.
std::optional<int> streamAt([[maybe_unused]] const fs::path& file) {
#ifndef _WIN32
    const std::string folder = file.parent_path().string(), name = file.filename().string();
    const std::string own = "/proc/" + std::to_string(getpid()) + "/";
    const bool holdsStreams = folder == "/dev/fd" || (folder.compare(0, own.size(), own) == 0 &&
                                                      folder.substr(folder.size() - 3) == "/fd");
    int stream = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data(), end, stream);
    if (holdsStreams && read.ec == std::errc() && read.ptr == end && stream >= 0) return stream;
#endif
    return std::nullopt;
}

// The device that takes everything: on Windows it lies in no folder.
bool isNull([[maybe_unused]] const fs::path& path) {
#ifdef _WIN32
    return _wcsicmp(path.c_str(), L"nul") == 0;
#else
    return false;
#endif
}

}  // namespace

bool Target::isSpecial() const {
    if (isNull(file)) return true;
    std::error_code none;
    const fs::file_status status = fs::status(file, none);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

Target targetOf(const fs::path& path) {
    if (path.empty()) throw FileError("expected the name of a file, found an empty one");
    if (path.filename().empty())
        throw FileError(path.string() + ": is a folder; expected the name of a file");
    if (const auto stream = standardStream(path)) return {path, stream};
    if (isNull(path)) return {path, std::nullopt};
    std::error_code error;
    fs::path file = fs::absolute(path, error);
    if (error) failToWrite(path, "the working folder does not exist any more");
    constexpr int mostLinks = 40;
    for (int i = 0; i < mostLinks; ++i) {
        const fs::path folder = fs::weakly_canonical(file.parent_path(), error);
        if (!error) file = folder / file.filename();
        if (const auto stream = streamAt(file)) return {file, stream};
        if (!fs::is_symlink(file, error)) return {file, std::nullopt};
        file = file.parent_path() / fs::read_symlink(file, error);
    }
    failToWrite(path, "it is a symbolic link that leads nowhere");
}

}  // namespace sw
