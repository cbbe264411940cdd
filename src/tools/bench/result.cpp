#include "tools/bench/result.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/common/table.h"

namespace bench {
namespace {

using report::Row;
using Json = nlohmann::ordered_json;

// Three digits, without powers of ten.
std::string threeDigits(double value) {
    const double size = std::fabs(value);
    return report::fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

std::string describe(const std::optional<Target>& target) {
    if (!target) return "";
    return (target->kind == Target::atLeast ? ">= " : "<= ") + threeDigits(target->value);
}

std::string describe(const std::optional<bool>& met) {
    return !met ? "" : *met ? "yes" : "no";
}

std::string describe(const std::optional<double>& ratio) {
    return ratio ? threeDigits(*ratio) : "";
}

Json asJson(const Line& line) {
    Json json{{"what", line.what}, {"other", line.other},   {"unit", line.unit},
              {"ours", line.ours}, {"theirs", line.theirs}, {"ratio", line.ratio}};
    if (line.target) {
        json[line.target->kind == Target::atLeast ? "at_least" : "at_most"] = line.target->value;
        json["met"] = *line.met();
    }
    if (line.misses) json["misses"] = *line.misses;
    if (line.hits) json["hits"] = *line.hits;
    return json;
}

}  // namespace

std::optional<bool> Line::met() const {
    if (!target) return std::nullopt;
    return target->kind == Target::atLeast ? ratio >= target->value : ratio <= target->value;
}

std::string toTable(const Lines& lines) {
    std::vector<Row> rows{
        {"what", "against", "unit", "ours", "other", "ratio", "target", "met", "misses", "hits"}};
    for (const Line& line : lines)
        rows.push_back({line.what, line.other, line.unit, threeDigits(line.ours),
                        threeDigits(line.theirs), threeDigits(line.ratio), describe(line.target),
                        describe(line.met()), describe(line.misses), describe(line.hits)});
    return report::table(rows, 3);
}

std::string toJson(const Lines& lines, const std::string& machine,
                   const std::vector<std::string>& notes) {
    Json json{{"machine", machine}, {"notes", notes}, {"lines", Json::array()}};
    for (const Line& line : lines) json["lines"].push_back(asJson(line));
    return json.dump(2) + "\n";
}

}  // namespace bench
