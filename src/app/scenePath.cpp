#include "app/scenePath.h"

#include <system_error>

namespace fs = std::filesystem;

namespace {

// The folder of the running program, or nothing if the system does not tell.
fs::path programFolder(const char* program) {
    std::error_code none;
    const fs::path self = fs::read_symlink("/proc/self/exe", none);
    return (self.empty() ? fs::weakly_canonical(program, none) : self).parent_path();
}

}  // namespace

fs::path findShippedScene(const char* name, const char* program) {
    const fs::path folders[] = {programFolder(program) / SW_SCENES_FROM_PROGRAM, SW_SOURCE_SCENES,
                                SW_INSTALLED_SCENES};
    for (const fs::path& folder : folders) {
        std::error_code none;
        if (fs::exists(folder / name, none)) return fs::weakly_canonical(folder / name, none);
    }
    return name;
}
