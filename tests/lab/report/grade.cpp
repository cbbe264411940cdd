#include "lab/report/grade.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace lab {
namespace {

using Json = nlohmann::ordered_json;
using State = Outcome::State;

bool passed(const Outcome& outcome) {
    return outcome.state == State::passed && !outcome.outOfDate;
}

bool hasRun(const Outcome& outcome) {
    return outcome.state != State::notRun && !outcome.outOfDate;
}

std::string verdict(const Outcome& outcome) {
    if (!hasRun(outcome)) return "not run";
    if (outcome.state != State::crashed) return "failed";
    const std::string& end = outcome.record.end;
    if (end == "recursion") return "endless recursion";
    if (end == "time") return "took too long";
    return end == "exit" ? "called exit()" : "crashed";
}

Json failures(const Task& task) {
    Json list = Json::array();
    for (const Outcome& outcome : task.outcomes)
        if (!passed(outcome))
            list.push_back({{"test", outcome.record.test},
                            {"verdict", verdict(outcome)},
                            {"hint", hasRun(outcome) ? outcome.record.hint : ""}});
    return list;
}

int countOf(const Task& task, bool (*property)(const Outcome&)) {
    return static_cast<int>(std::count_if(task.outcomes.begin(), task.outcomes.end(), property));
}

// Out of so many.
int pointsOf(const Task& task, int of) {
    const auto product = static_cast<std::int64_t>(of) * countOf(task, passed);
    return task.size() == 0 ? 0 : static_cast<int>(product / task.size());
}

Json objectOf(const Task& task, int of) {
    Json object{
        {"label", task.label},  {"title", task.title},          {"passed", countOf(task, passed)},
        {"tests", task.size()}, {"points", pointsOf(task, of)}, {"of", of}};
    if (countOf(task, hasRun) == 0) object["note"] = "not run";
    object["failed"] = failures(task);
    return object;
}

}  // namespace

std::string grade(const std::vector<Task>& tasks, const std::vector<int>& points) {
    Json objects = Json::array();
    int total = 0, possible = 0;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        objects.push_back(objectOf(tasks[i], points.at(i)));
        total += pointsOf(tasks[i], points[i]);
        possible += points[i];
    }
    const Json all{{"tasks", objects}, {"total", total}, {"of", possible}};
    // Bytes that are no UTF-8 become U+FFFD.
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lab
