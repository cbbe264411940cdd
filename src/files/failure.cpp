#include "files/failure.h"

#include <cerrno>
#include <system_error>

#include "swFile.h"

namespace sw {

void failToWrite(const std::filesystem::path& path, const std::string& why) {
    throw FileError(path.string() + ": cannot write: " + why);
}

std::string reasonOf(int error) {
    return std::generic_category().message(error ? error : EIO);
}

}  // namespace sw
