#include "tools/common/command.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace report {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}

#ifdef _WIN32

bool isInstalled(const std::string&) {
    return false;
}
std::string outputOf(const std::string& command, const std::filesystem::path&) {
    throw std::runtime_error("cannot run on Windows: " + command);
}

#else

bool isInstalled(const std::string& program) {
    return std::system((quoted(program) + " --version > /dev/null 2>&1").c_str()) == 0;
}

std::string outputOf(const std::string& command, const std::filesystem::path& folder) {
    const std::string line = "cd " + quoted(folder.string()) + " && " + command + " 2>&1";
    FILE* pipe = popen(line.c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run: " + line);
    std::string output;
    char part[4096];
    while (const std::size_t count = std::fread(part, 1, sizeof part, pipe))
        output.append(part, count);
    constexpr std::size_t shown = 1000;
    if (pclose(pipe) != 0)
        throw std::runtime_error("failed: " + line + "\n" +
                                 output.substr(output.size() > shown ? output.size() - shown : 0));
    return output;
}

#endif

}  // namespace report
