#include "app/scenePath.h"

#include <system_error>

#include "files/utf8Path.h"
#include "files/windowsApi.h"

namespace fs = std::filesystem;

namespace {

// The folder of the running program, or nothing if the system does not tell.
#ifdef _WIN32
fs::path programFolder(const char*) {
    std::wstring name(1 << 15, L'\0');
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return fs::path(name).parent_path();
}
#else
fs::path programFolder(const char* program) {
    std::error_code none;
    const fs::path self = fs::read_symlink("/proc/self/exe", none);
    return (self.empty() ? fs::weakly_canonical(program, none) : self).parent_path();
}
#endif

}  // namespace

fs::path findShippedScene(const char* name, const char* program) {
    // A path from the root stays what it is; on Windows it is meant on the program's drive.
    const fs::path here = programFolder(program);
    const fs::path folders[] = {here / sw::pathOfUtf8(SW_SCENES_FROM_PROGRAM),
                                here / sw::pathOfUtf8(SW_SOURCE_SCENES),
                                here / sw::pathOfUtf8(SW_INSTALLED_SCENES)};
    for (const fs::path& folder : folders) {
        std::error_code none;
        if (fs::exists(folder / name, none)) return fs::weakly_canonical(folder / name, none);
    }
    return name;
}
