#include "regions.h"

#include <algorithm>
#include <optional>

namespace kit {
namespace {

constexpr auto npos = std::string_view::npos;

// A line without its indentation.
std::string_view trimmed(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t");
    const std::size_t end = line.find_last_not_of(" \t\r\n");
    return start == npos ? std::string_view() : line.substr(start, end + 1 - start);
}

std::string_view takeLine(std::string_view& text) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(length);
    return line;
}

// What a comment says, in C++ or CMake; nothing if the line is none.
std::optional<std::string_view> comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (text.starts_with("//")) return text.substr(2);
    if (text.starts_with("#")) return text.substr(1);
    return std::nullopt;
}

// The name of the region that begins in this line.
std::optional<std::string> beginning(std::string_view line) {
    const auto text = comment(line);
    if (!text || !text->starts_with(" ") || !text->ends_with(" >>>")) return std::nullopt;
    return std::string(trimmed(text->substr(0, text->size() - 4)));
}

bool isEnd(std::string_view line) {
    return comment(line) == " <<<";
}

// The starter's line that a comment carries.
std::optional<std::string> starterLine(std::string_view line) {
    const auto text = comment(line);
    if (!text || !text->starts_with("|")) return std::nullopt;
    const std::string_view content = text->substr(std::min<std::size_t>(2, text->size()));
    if (content.empty()) return "\n";
    return std::string(line.substr(0, line.find_first_not_of(" \t"))).append(content).append("\n");
}

std::string place(const std::string& name, int line) {
    return name + ":" + std::to_string(line) + ": ";
}

}  // namespace

Source cut(std::string_view text, const std::string& name) {
    Source source;
    source.common.emplace_back();
    bool inside = false;
    int number = 0, begun = 0;
    while (!text.empty()) {
        const std::string_view line = takeLine(text);
        ++number;
        const auto region = beginning(line);
        if (region && inside)
            throw KitError(place(name, number) + "expected `<<<` to end the region of line " +
                           std::to_string(begun) + ", found another beginning");
        if (isEnd(line) && !inside)
            throw KitError(place(name, number) + "expected a region to end, found none begun");
        if (region) {
            source.regions.push_back({*region, {}, {}});
            inside = true;
            begun = number;
        } else if (isEnd(line)) {
            source.common.emplace_back();
            inside = false;
        } else if (!inside) {
            source.common.back() += line;
        } else if (const auto starter = starterLine(line)) {
            source.regions.back().starter += *starter;
        } else {
            source.regions.back().solution += line;
        }
    }
    if (inside)
        throw KitError(place(name, begun) + "expected `<<<` to end this region, found the end");
    return source;
}

std::string starterOf(const Source& source) {
    std::string text = source.common.front();
    for (std::size_t i = 0; i < source.regions.size(); ++i)
        text += source.regions[i].starter + source.common[i + 1];
    for (std::size_t at; (at = text.find("\n\n\n")) != npos;) text.erase(at, 1);
    return text;
}

const std::string& solutionOf(const Source& source, const std::string& region,
                              const std::string& name) {
    const auto hasName = [&](const Region& r) { return r.name == region; };
    const auto found = std::find_if(source.regions.begin(), source.regions.end(), hasName);
    const auto count = std::count_if(source.regions.begin(), source.regions.end(), hasName);
    if (count != 1)
        throw KitError(name + ": expected one region '" + region + "', found " +
                       std::to_string(count));
    return found->solution;
}

}  // namespace kit
