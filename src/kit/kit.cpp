#include "kit.h"

#include <algorithm>
#include <sstream>

#include "swFile.h"

namespace kit {
namespace {

namespace fs = std::filesystem;

bool hasRegions(const fs::path& file) {
    const fs::path ending = file.extension();
    return ending == ".cpp" || ending == ".h" || file.filename() == "CMakeLists.txt";
}

std::string starterOf(const fs::path& file) {
    const std::string text = sw::readFile(file);
    return hasRegions(file) ? starterOf(cut(text, file.string())) : text;
}

void writeInto(const fs::path& folder, const fs::path& file, const std::string& content) {
    fs::create_directories((folder / file).parent_path());
    sw::writeFile(folder / file, content);
}

// The files that a line of the list stands for.
std::vector<fs::path> matches(const fs::path& pattern, const fs::path& project) {
    if (pattern.stem() != "*") {
        if (fs::is_regular_file(project / pattern)) return {pattern};
        return {};
    }
    std::vector<fs::path> files;
    const fs::path folder = pattern.parent_path();
    if (!fs::is_directory(project / folder)) return {};
    for (const auto& entry : fs::directory_iterator(project / folder))
        if (entry.is_regular_file() && entry.path().extension() == pattern.extension())
            files.push_back(folder / entry.path().filename());
    return files;
}

std::string withoutComment(const std::string& line) {
    const std::string text = line.substr(0, line.find('#'));
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

}  // namespace

std::vector<fs::path> filesOf(const std::string& list, const fs::path& project) {
    std::vector<fs::path> files;
    std::istringstream in(list);
    for (std::string line; std::getline(in, line);) {
        line = withoutComment(line);
        if (line.empty()) continue;
        const bool leavesOut = line.starts_with("- ");
        const std::vector<fs::path> named = matches(leavesOut ? line.substr(2) : line, project);
        const std::size_t before = files.size();
        if (leavesOut)
            for (const fs::path& file : named) std::erase(files, file);
        else
            files.insert(files.end(), named.begin(), named.end());
        if (files.size() == before)
            throw KitError("the kit's list: expected files for '" + line + "', found none");
    }
    std::sort(files.begin(), files.end());
    return files;
}

void makeKit(const fs::path& project, const fs::path& kit) {
    if (fs::exists(kit) && !fs::is_empty(kit))
        throw KitError(kit.string() + ": expected an empty folder, found files in it");
    const std::string list = sw::readFile(project / "src/kit/files.txt");
    for (const fs::path& file : filesOf(list, project))
        writeInto(kit, file, starterOf(project / file));
    const fs::path own = project / "src/kit/files";
    for (const auto& entry : fs::recursive_directory_iterator(own))
        if (entry.is_regular_file())
            writeInto(kit, entry.path().lexically_relative(own), sw::readFile(entry.path()));
}

std::string filled(const std::string& text, const std::string& name, const fs::path& project) {
    constexpr std::string_view mark = "//= ";
    std::string result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(mark)) {
            result += line + "\n";
            continue;
        }
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos)
            throw KitError(name + ": expected '//= file: region', found: " + line);
        const fs::path file = project / line.substr(mark.size(), colon - mark.size());
        const Source source = cut(sw::readFile(file), file.string());
        result += solutionOf(source, line.substr(colon + 2), file.string());
    }
    return result;
}

}  // namespace kit
