// How writeFile() and requireWritable() of swFile.h reach what a path names.
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <system_error>

#include "files/failure.h"
#include "files/stream.h"
#include "files/target.h"
#include "files/temporary.h"
#include "files/windowsApi.h"
#include "swFile.h"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace sw {
namespace {

namespace fs = std::filesystem;

void requireFolder(const fs::path& path, const fs::path& target) {
    std::error_code none;
    if (fs::is_directory(target, none))
        throw FileError(path.string() + ": is a folder; expected the name of a file");
    if (!fs::is_directory(target.parent_path(), none))
        failToWrite(path, "there is no folder " + target.parent_path().string() +
                              "; create it or name another");
}

#ifdef _WIN32

// Windows lets no two programs write a file, unless both want that.
std::string reasonNotToOpen(const fs::path& file) {
    const HANDLE handle =
        CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                    nullptr, OPEN_EXISTING, 0, nullptr);
    if (handle == INVALID_HANDLE_VALUE && GetLastError() == ERROR_SHARING_VIOLATION)
        return "another program has it open; close it there, or name another file";
    if (handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
    return handle == INVALID_HANDLE_VALUE ? reasonOf(EACCES) : "";
}
bool isWritable(const fs::path&) {
    return true;
}
bool isProtectedBySticky(const fs::path&) {
    return false;
}
void keepOwner(const fs::path&, const fs::path&) {}

#else

std::string reasonNotToOpen(const fs::path& file) {
    errno = 0;
    const std::fstream opened(file, std::ios::in | std::ios::out | std::ios::binary);
    return opened ? "" : reasonOf(errno);
}

bool isWritable(const fs::path& path) {
    return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

// In a folder like /tmp only its owner and the file's may replace a file.
bool isProtectedBySticky(const fs::path& file) {
    struct stat own {};
    struct stat folder {};
    if (stat(file.c_str(), &own) != 0 || stat(file.parent_path().c_str(), &folder) != 0)
        return false;
    const uid_t user = geteuid();
    return (folder.st_mode & S_ISVTX) != 0 && user != 0 && own.st_uid != user &&
           folder.st_uid != user;
}

// Only root may give files away; for others the new file is their own.
void keepOwner(const fs::path& from, const fs::path& to) {
    struct stat old {};
    if (geteuid() != 0 || stat(from.c_str(), &old) != 0) return;
    static_cast<void>(chown(to.c_str(), old.st_uid, old.st_gid) == 0);
}

#endif

// Whether a new file may take the target's place. Otherwise the old one gets new content: that of
// all its hard links.
bool canBeReplaced(const fs::path& file) {
    std::error_code none;
    if (!fs::exists(file, none)) return true;
    return fs::hard_link_count(file, none) <= 1 && isWritable(file.parent_path()) &&
           !isProtectedBySticky(file);
}

void keepMode(const fs::path& from, const fs::path& to) {
    std::error_code error;
    const fs::perms mode = fs::status(from, error).permissions();
    if (error || mode == fs::perms::unknown || !fs::exists(from, error)) return;
    keepOwner(from, to);
    fs::permissions(to, mode, error);
}

void fill(const fs::path& file, std::ios::openmode mode, std::string_view content,
          const fs::path& named) {
    errno = 0;
    std::fstream out(file, mode | std::ios::out | std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) failToWrite(named, reasonOf(errno));
}

// Returns false if the old file cannot be replaced after all: it is mounted, or open elsewhere.
bool replace(const fs::path& file, std::string_view content, const fs::path& named) {
    const Temporary temporary(file, named);
    keepMode(file, temporary.path);
    fill(temporary.path, std::ios::trunc, content, named);
    std::error_code error, none;
    fs::rename(temporary.path, file, error);
    if (error && !fs::exists(file, none)) failToWrite(named, error.message());
    return !error;
}

void overwrite(const fs::path& file, std::string_view content, const fs::path& named) {
    fill(file, std::ios::in, content, named);  // with `in`, the file is not emptied first
    std::error_code error;
    fs::resize_file(file, content.size(), error);
    if (error) failToWrite(named, error.message());
}

// Locked, immutable, of another user: what opening tells.
void requireOpens(const fs::path& file, const fs::path& named) {
    const std::string reason = reasonNotToOpen(file);
    if (!reason.empty()) failToWrite(named, reason);
}

}  // namespace

void writeFile(const fs::path& path, std::string_view content) {
    const Target target = targetOf(path);
    if (target.stream) return writeToStream(*target.stream, content, path);
    if (target.isSpecial()) return fill(target.file, std::ios::trunc, content, path);
    requireFolder(path, target.file);
    removeStale(target.file);
    if (!canBeReplaced(target.file) || !replace(target.file, content, path))
        overwrite(target.file, content, path);
}

void requireWritable(const fs::path& path, std::uintmax_t leastSize) {
    const Target target = targetOf(path);
    if (target.stream) return requireOpen(*target.stream, path);
    if (target.isSpecial()) {
        if (!isWritable(target.file)) failToWrite(path, reasonOf(EACCES));
        return;
    }
    requireFolder(path, target.file);
    removeStale(target.file);
    std::error_code none;
    if (fs::exists(target.file, none)) requireOpens(target.file, path);
    if (!canBeReplaced(target.file)) return;
    const Temporary temporary(target.file, path);
    fill(temporary.path, std::ios::trunc, "?", path);  // a full disk has no room for it
    std::error_code error;
    fs::resize_file(temporary.path, leastSize, error);  // takes no room, but the limit holds
    if (error) failToWrite(path, error.message());
}

}  // namespace sw
