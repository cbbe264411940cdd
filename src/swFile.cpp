#include "swFile.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <random>
#include <system_error>

namespace sw {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error ? error : EIO);
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw FileError(path.string() + ": " + why);
}

// The file that the bytes really go to: symbolic links are followed, and stay as they are.
fs::path resolve(const fs::path& path) {
    if (path.empty()) fail(path, "expected the name of a file, found an empty one");
    if (path.filename().empty()) fail(path, "is a folder; expected the name of a file");
    constexpr int mostLinks = 40;
    std::error_code none;
    fs::path target = fs::absolute(path);
    for (int i = 0; i < mostLinks && fs::is_symlink(target, none); ++i)
        target = target.parent_path() / fs::read_symlink(target, none);
    return target.lexically_normal();
}

bool isSpecial(const fs::path& path) {
    std::error_code none;
    const fs::file_status status = fs::status(path, none);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// A name beside the target that no other run of the program uses.
fs::path temporaryFor(const fs::path& target) {
    fs::path name = target;
    name += ".tmp" + std::to_string(std::random_device()());
    return name;
}

void requireFolder(const fs::path& path, const fs::path& target) {
    std::error_code none;
    if (fs::is_directory(target, none)) fail(path, "is a folder; expected the name of a file");
    if (!fs::is_directory(target.parent_path(), none))
        fail(path, "cannot write: there is no folder " + target.parent_path().string() +
                       "; create it or name another");
}

void writeThrough(const fs::path& file, std::string_view content, const fs::path& named) {
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out) fail(named, "cannot write: " + reason(errno));
}

// Removes the temporary file unless it was renamed.
struct Temporary {
    fs::path path;
    ~Temporary() {
        std::error_code none;
        fs::remove(path, none);
    }
};

}  // namespace

std::string readFile(const fs::path& path) {
    std::error_code none;
    if (!fs::exists(path, none)) fail(path, "not found; is the path right?");
    if (fs::is_directory(path, none)) fail(path, "is a folder; expected a file");
    // Not an ifstream: with some libraries a read error looks like the end of the file.
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(
        std::fopen(path.string().c_str(), "rb"), std::fclose);
    if (!in) fail(path, "cannot read: " + reason(errno));
    std::string content;
    const auto size = fs::file_size(path, none);
    if (!none) content.reserve(size);
    char part[1 << 14];
    while (const std::size_t n = std::fread(part, 1, sizeof part, in.get()))
        content.append(part, n);
    if (std::ferror(in.get()) != 0) fail(path, "cannot read: " + reason(errno));
    return content;
}

void writeFile(const fs::path& path, std::string_view content) {
    const fs::path target = resolve(path);
    if (isSpecial(target)) return writeThrough(target, content, path);
    requireFolder(path, target);
    const Temporary temporary{temporaryFor(target)};
    writeThrough(temporary.path, content, path);
    std::error_code error;
    fs::rename(temporary.path, target, error);
    if (error) fail(path, "cannot write: " + error.message());
}

void requireWritable(const fs::path& path) {
    const fs::path target = resolve(path);
    if (isSpecial(target)) return;
    requireFolder(path, target);
    const Temporary temporary{temporaryFor(target)};
    writeThrough(temporary.path, "", path);
}

}  // namespace sw
