#include "tools/bench/result.h"
#include "nff/plainText.h"

#include <cmath>
#include <iomanip>

#include "tools/common/table.h"

namespace bench {
namespace {

using report::Row;
using report::table;
using sw::plainStream;

// Three digits, without powers of ten.
std::string rounded(double value) {
    const double size = std::fabs(value);
    auto text = plainStream();
    text << std::fixed
         << std::setprecision(size >= 100  ? 0
                              : size >= 10 ? 1
                              : size >= 1  ? 2
                                           : 3)
         << value;
    return text.str();
}

std::string describe(const std::optional<Target>& target) {
    if (!target) return "";
    return (target->kind == Target::atLeast ? ">= " : "<= ") + rounded(target->value);
}

std::string describe(const std::optional<bool>& met) {
    return !met ? "" : *met ? "yes" : "no";
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + "\"";
}

// JSON has no infinity.
std::string number(double value) {
    if (!std::isfinite(value)) return "null";
    auto text = plainStream();
    text << std::setprecision(6) << value;
    return text.str();
}

std::string toJson(const Line& line) {
    std::string json = "{\"what\": " + quoted(line.what) + ", \"other\": " + quoted(line.other) +
                       ", \"unit\": " + quoted(line.unit) + ", \"ours\": " + number(line.ours) +
                       ", \"theirs\": " + number(line.theirs) +
                       ", \"ratio\": " + number(line.ratio);
    if (line.target) {
        const char* name = line.target->kind == Target::atLeast ? "at_least" : "at_most";
        json += ", \"" + std::string(name) + "\": " + number(line.target->value) +
                ", \"met\": " + (*line.met() ? "true" : "false");
    }
    return json + "}";
}

}  // namespace

std::optional<bool> Line::met() const {
    if (!target) return std::nullopt;
    return target->kind == Target::atLeast ? ratio >= target->value : ratio <= target->value;
}

std::string toTable(const Lines& lines) {
    std::vector<Row> rows{{"what", "against", "unit", "ours", "other", "ratio", "target", "met"}};
    for (const Line& line : lines)
        rows.push_back({line.what, line.other, line.unit, rounded(line.ours), rounded(line.theirs),
                        rounded(line.ratio), describe(line.target), describe(line.met())});
    return table(rows, 3);
}

std::string toJson(const Lines& lines, const std::string& machine,
                   const std::vector<std::string>& notes) {
    std::string json = "{\n  \"machine\": " + quoted(machine) + ",\n  \"notes\": [";
    for (std::size_t i = 0; i < notes.size(); ++i) json += (i > 0 ? ", " : "") + quoted(notes[i]);
    json += "],\n  \"lines\": [";
    for (std::size_t i = 0; i < lines.size(); ++i)
        json += (i > 0 ? ",\n    " : "\n    ") + toJson(lines[i]);
    return json + "\n  ]\n}\n";
}

}  // namespace bench
