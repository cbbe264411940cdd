#include "lab/record.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <tuple>
#include <utility>

#include "swFile.h"

namespace lab {
namespace {

namespace fs = std::filesystem;

// A file is lines of "key value". The first says what it is, the last that nothing is missing.
using Line = std::pair<std::string, std::string>;
constexpr const char* recordStart = "swtracer-lab-record 1\n";
constexpr const char* testsStart = "swtracer-lab-tests 1\n";
constexpr const char* end = "end \n";
constexpr const char* testsFile = "tests.txt";

// On one line, whatever it holds.
std::string oneLine(const std::string& text) {
    std::string line;
    for (const char c : text) {
        if (c == '\n')
            line += "\\n";
        else if (c == '\\')
            line += "\\\\";
        else
            line += c;
    }
    return line;
}

std::string manyLines(const std::string& line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool special = line[i] == '\\' && i + 1 < line.size();
        if (special) ++i;
        text += special && line[i] == 'n' ? '\n' : line[i];
    }
    return text;
}

std::string keyAndValue(const std::string& key, const std::string& value) {
    return key + " " + oneLine(value) + "\n";
}

std::string keyAndValue(const std::string& key, int value) {
    return keyAndValue(key, std::to_string(value));
}

int number(const std::string& text) {
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// The lines between start and end; none if it is another file, or not whole.
std::vector<Line> linesOf(const fs::path& file, const std::string& start) {
    std::string content;
    try {
        content = sw::readFile(file);
    } catch (const sw::FileError&) {
        return {};
    }
    if (content.rfind(start, 0) != 0) return {};
    std::vector<Line> lines;
    for (std::size_t at = start.size(), next; at < content.size(); at = next) {
        next = std::min(content.find('\n', at), content.size() - 1) + 1;
        const std::string line = content.substr(at, next - 1 - at);
        const std::size_t space = std::min(line.find(' '), line.size() - 1);
        lines.emplace_back(line.substr(0, space), manyLines(line.substr(space + 1)));
    }
    if (lines.empty() || lines.back() != Line("end", "")) return {};
    return lines;
}

// One name per test, the same in every run.
std::string fileName(const Record& record) {
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const char c : record.test) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return "lab" + std::to_string(record.task) + "-" + std::to_string(hash) + ".record";
}

constexpr std::pair<Record::Verdict, const char*> verdicts[] = {
    {Record::Verdict::passed, "passed"},
    {Record::Verdict::failed, "failed"},
    {Record::Verdict::unfinished, "unfinished"}};

std::string word(Record::Verdict verdict) {
    for (const auto& [value, name] : verdicts)
        if (value == verdict) return name;
    return "unfinished";
}

Record::Verdict verdictOf(const std::string& word) {
    for (const auto& [value, name] : verdicts)
        if (name == word) return value;
    return Record::Verdict::unfinished;
}

// The fields of a record that hold text.
std::string* textField(Record& record, const std::string& key) {
    if (key == "test") return &record.test;
    if (key == "tried") return &record.tried;
    if (key == "got") return &record.got;
    if (key == "expected") return &record.expected;
    if (key == "hint") return &record.hint;
    return nullptr;
}

void setPictureField(PictureRecord& picture, const std::string& key, const std::string& value) {
    if (key == "picture-expected") picture.expected = value;
    if (key == "picture-got") picture.got = value;
    if (key == "picture-difference") picture.difference = value;
    if (key == "picture-x") picture.x = number(value);
    if (key == "picture-y") picture.y = number(value);
    if (key == "picture-steps") picture.steps = number(value);
}

// A key that nobody knows is passed over.
Record recordOf(const std::vector<Line>& lines) {
    Record record;
    for (const auto& [key, value] : lines) {
        if (key == "task") record.task = number(value);
        if (key == "verdict") record.verdict = verdictOf(value);
        if (key == "milliseconds") record.seconds = number(value) / 1000.0;
        if (key == "picture") record.pictures.emplace_back().name = value;
        if (std::string* const text = textField(record, key)) *text = value;
        if (!record.pictures.empty()) setPictureField(record.pictures.back(), key, value);
    }
    return record;
}

std::string textOf(const PictureRecord& picture) {
    return keyAndValue("picture", picture.name) +
           keyAndValue("picture-expected", picture.expected) +
           keyAndValue("picture-got", picture.got) +
           keyAndValue("picture-difference", picture.difference) +
           keyAndValue("picture-x", picture.x) + keyAndValue("picture-y", picture.y) +
           keyAndValue("picture-steps", picture.steps);
}

// Three lines, of which the last ones may be empty or missing.
void readEnd(Record& record, const fs::path& file) {
    std::error_code none;
    if (record.verdict != Record::Verdict::unfinished || !fs::exists(file, none)) return;
    const std::string text = sw::readFile(file);
    const std::size_t first = std::min(text.find('\n'), text.size());
    const std::size_t second = std::min(text.find('\n', first + 1), text.size());
    record.end = text.substr(0, first);
    if (first < text.size()) record.endDetail = text.substr(first + 1, second - first - 1);
    if (second < text.size()) record.endFunction = text.substr(second + 1);
}

}  // namespace

void write(const Record& record, const fs::path& folder) {
    std::string content =
        recordStart + keyAndValue("task", record.task) + keyAndValue("test", record.test) +
        keyAndValue("verdict", word(record.verdict)) + keyAndValue("tried", record.tried) +
        keyAndValue("got", record.got) + keyAndValue("expected", record.expected) +
        keyAndValue("hint", record.hint) +
        keyAndValue("milliseconds", static_cast<int>(1000 * record.seconds));
    for (const PictureRecord& picture : record.pictures) content += textOf(picture);
    fs::create_directories(folder);
    sw::writeFile(folder / fileName(record), content + end);
}

fs::path endFile(const Record& record, const fs::path& folder) {
    return (folder / fileName(record)).replace_extension(".end");
}

std::vector<Record> readAll(const fs::path& folder) {
    std::vector<Record> records;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".record") continue;
        const auto lines = linesOf(entry.path(), recordStart);
        if (lines.empty()) continue;
        records.push_back(recordOf(lines));
        readEnd(records.back(), endFile(records.back(), folder));
        records.back().when = fs::last_write_time(entry.path(), none);
    }
    std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) {
        return std::tie(a.task, a.test) < std::tie(b.task, b.test);
    });
    return records;
}

Record& running() {
    static Record record;
    return record;
}

void writeTests(const std::vector<Test>& tests, const fs::path& folder) {
    if (readTests(folder) == tests) return;
    std::string content = testsStart;
    for (const Test& test : tests)
        content += keyAndValue("lab" + std::to_string(test.task), test.name);
    fs::create_directories(folder);
    sw::writeFile(folder / testsFile, content + end);
}

std::vector<Test> readTests(const fs::path& folder) {
    std::vector<Test> tests;
    for (const auto& [key, value] : linesOf(folder / testsFile, testsStart))
        if (key.rfind("lab", 0) == 0) tests.push_back({number(key.substr(3)), value});
    return tests;
}

}  // namespace lab
