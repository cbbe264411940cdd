#include "edit.h"

#include <charconv>
#include <map>
#include <sstream>

#include "swFile.h"

namespace kit {
namespace {

class EditParser {
public:
    EditParser(std::string_view text, const std::string& what)
        : in(std::string(text)), edit{what, 0, {}, {}} {}

    Edit parse() {
        while (next())
            if (line == "<<<<")
                readBlock();
            else if (!line.empty())
                readHeading();
        if (edit.replacements.empty()) fail("expected a block that begins with '<<<<', found none");
        return edit;
    }

private:
    bool next() {
        ++number;
        return static_cast<bool>(std::getline(in, line));
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw KitError(edit.name + ":" + std::to_string(number) + ": " + message);
    }

    void readHeading() {
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) fail("expected 'key: value' or '<<<<', found: " + line);
        const std::string key = line.substr(0, colon), value = line.substr(colon + 2);
        if (key == "file")
            file = value;
        else if (key == "says")
            edit.says = value;
        else if (key == "task")
            std::from_chars(value.data(), value.data() + value.size(), edit.task);
        else
            fail("expected task, says or file, found: " + key);
    }

    void readBlock() {
        if (file.empty()) fail("expected 'file: ...' before the first block");
        std::string before = linesUntil("===="), after = linesUntil(">>>>");
        edit.replacements.push_back({file, std::move(before), std::move(after)});
    }

    std::string linesUntil(const std::string& end) {
        std::string lines;
        while (next()) {
            if (line == end) return lines;
            lines += line + "\n";
        }
        fail("expected '" + end + "', found the end of the file");
    }

    std::istringstream in;
    std::string line, file;
    int number = 0;
    Edit edit;
};

}  // namespace

Edit parseEdit(std::string_view text, const std::string& name) {
    return EditParser(text, name).parse();
}

void apply(const Edit& edit, const std::filesystem::path& folder) {
    std::map<std::string, std::string> changed;
    for (const Replacement& r : edit.replacements) {
        const auto [entry, isNew] = changed.try_emplace(r.file);
        std::string& text = entry->second;
        if (isNew) text = sw::readFile(folder / r.file);
        const std::size_t at = text.find(r.before);
        if (at == std::string::npos || text.find(r.before, at + 1) != std::string::npos)
            throw KitError(edit.name + ": expected this once in " + r.file + ", found it " +
                           (at == std::string::npos ? "nowhere" : "more than once") + ":\n" +
                           r.before);
        text.replace(at, r.before.size(), r.after);
    }
    for (const auto& [file, text] : changed) sw::writeFile(folder / file, text);
}

}  // namespace kit
