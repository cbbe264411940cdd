#include "swFile.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "files/standardStream.h"

namespace sw {

std::string readFile(const std::filesystem::path& path) {
    const auto fail = [&](const std::string& why) { throw FileError(path.string() + ": " + why); };
    const auto reason = [](int error) {
        return "cannot read: " + std::generic_category().message(error ? error : EIO);
    };
    // Not an ifstream: with some libraries a read error looks like the end of the file.
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(openToRead(path), std::fclose);
    const int error = errno;
    std::error_code none;
    if (!in && !std::filesystem::exists(path, none)) fail("not found; is the path right?");
    if (std::filesystem::is_directory(path, none)) fail("is a folder; expected a file");
    if (!in) fail(reason(error));
    if (isDevice(in.get())) fail("is a device; expected a file");
    std::string content;
    const auto size = std::filesystem::file_size(path, none);
    if (!none) content.reserve(static_cast<std::size_t>(size));
    char part[1 << 14];
    while (const std::size_t n = std::fread(part, 1, sizeof part, in.get()))
        content.append(part, n);
    if (std::ferror(in.get()) != 0) fail(reason(errno));
    return content;
}

}  // namespace sw
