#include "grade.h"

#include <algorithm>
#include <cstdint>

#include "json.h"

namespace lab {
namespace {

using State = Outcome::State;

bool passed(const Outcome& outcome) {
    return outcome.state == State::passed && !outcome.outOfDate;
}

bool hasRun(const Outcome& outcome) {
    return outcome.state != State::notRun && !outcome.outOfDate;
}

std::string verdict(const Outcome& outcome) {
    if (!hasRun(outcome)) return "not run";
    return outcome.state == State::crashed ? "crashed" : "failed";
}

std::string failures(const Task& task) {
    std::string json;
    for (const Outcome& outcome : task.outcomes)
        if (!passed(outcome))
            json += std::string(json.empty() ? "" : ",") +
                    "\n      {\"test\": " + jsonString(outcome.record.test) + ", \"verdict\": \"" +
                    verdict(outcome) +
                    "\", \"hint\": " + jsonString(hasRun(outcome) ? outcome.record.hint : "") + "}";
    return "[" + json + (json.empty() ? "]" : "\n    ]");
}

int countOf(const Task& task, bool (*property)(const Outcome&)) {
    return static_cast<int>(std::count_if(task.outcomes.begin(), task.outcomes.end(), property));
}

// Out of so many.
int pointsOf(const Task& task, int of) {
    const auto product = static_cast<std::int64_t>(of) * countOf(task, passed);
    return task.size() == 0 ? 0 : static_cast<int>(product / task.size());
}

std::string field(const std::string& key, int value) {
    return "\"" + key + "\": " + std::to_string(value);
}

std::string objectOf(const Task& task, int of) {
    const bool any = countOf(task, hasRun) > 0;
    return "    {\"label\": " + jsonString(task.label) + ", \"title\": " + jsonString(task.title) +
           ", " + field("passed", countOf(task, passed)) + ", " + field("tests", task.size()) +
           ", " + field("points", pointsOf(task, of)) + ", " + field("of", of) +
           (any ? "" : ", \"note\": \"not run\"") + ",\n    \"failed\": " + failures(task) + "}";
}

}  // namespace

std::string grade(const std::vector<Task>& tasks, const std::vector<int>& points) {
    std::string objects;
    int total = 0, possible = 0;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        objects += (i == 0 ? "" : ",\n") + objectOf(tasks[i], points.at(i));
        total += pointsOf(tasks[i], points[i]);
        possible += points[i];
    }
    return "{\n  \"tasks\": [\n" + objects + "\n  ],\n  " + field("total", total) + ", " +
           field("of", possible) + "\n}\n";
}

}  // namespace lab
