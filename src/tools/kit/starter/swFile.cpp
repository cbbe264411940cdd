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

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
    throw FileError(path.string() + ": " + why);
}

}  // namespace

std::string readFile(const fs::path& path) {
    std::error_code none;
    if (!fs::exists(path, none)) fail(path, "not found; is the path right?");
    if (fs::is_directory(path, none)) fail(path, "is a folder; expected a file");
    // Not an ifstream: with some libraries a read error looks like the end of the file.
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(
        std::fopen(path.string().c_str(), "rb"), std::fclose);
    if (!in) fail(path, "cannot read: " + std::generic_category().message(errno));
    std::string content;
    char part[1 << 14];
    while (const std::size_t n = std::fread(part, 1, sizeof part, in.get()))
        content.append(part, n);
    if (std::ferror(in.get()) != 0)
        fail(path, "cannot read: " + std::generic_category().message(errno));
    return content;
}

void writeFile(const fs::path& path, std::string_view content) {
    requireWritable(path);
    fs::path temporary = path;
    temporary += ".tmp" + std::to_string(std::random_device()());
    std::ofstream out(temporary, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    std::error_code error, none;
    if (out) fs::rename(temporary, path, error);
    if (out && !error) return;
    fs::remove(temporary, none);
    fail(path, "cannot write; is the disk full, or the folder locked?");
}

void requireWritable(const fs::path& path, std::uintmax_t) {
    std::error_code none;
    if (path.filename().empty() || fs::is_directory(path, none))
        fail(path, "is a folder; expected the name of a file");
    if (path.has_parent_path() && !fs::is_directory(path.parent_path(), none))
        fail(path, "cannot write: there is no such folder; create it or name another");
}

}  // namespace sw
