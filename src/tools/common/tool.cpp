#include "tools/common/tool.h"

#include <system_error>

#include "swFile.h"

namespace report {

std::filesystem::path outputFile(const std::filesystem::path& folder, const char* name) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);  // requireWritable reports the error
    const std::filesystem::path file = folder / name;
    sw::requireWritable(file);
    return file;
}

}  // namespace report
