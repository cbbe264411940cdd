#include "lab/report/results.h"

#include <algorithm>

namespace lab {
namespace {

namespace fs = std::filesystem;

Outcome::State stateOf(Record::Verdict verdict) {
    switch (verdict) {
        case Record::Verdict::passed:
            return Outcome::State::passed;
        case Record::Verdict::failed:
            return Outcome::State::failed;
        default:
            return Outcome::State::crashed;
    }
}

Outcome outcomeOf(const Record& record, fs::file_time_type built) {
    return {record, stateOf(record.verdict), record.when < built};
}

Outcome notRun(const Test& test) {
    Outcome outcome;
    outcome.record.task = test.task;
    outcome.record.test = test.name;
    return outcome;
}

fs::file_time_type builtAt(const fs::path& program) {
    std::error_code error;
    const auto time = fs::last_write_time(program, error);
    return error ? fs::file_time_type::max() : time;
}

// What the records say of one test after the other.
std::vector<Outcome> outcomes(const std::vector<Test>& tests, const std::vector<Record>& records,
                              fs::file_time_type built) {
    std::vector<Outcome> found;
    for (const Test& test : tests) {
        const auto record = std::find_if(records.begin(), records.end(), [&](const Record& r) {
            return r.task == test.task && r.test == test.name;
        });
        found.push_back(record == records.end() ? notRun(test) : outcomeOf(*record, built));
    }
    return found;
}

}  // namespace

int Task::count(Outcome::State state) const {
    return static_cast<int>(
        std::count_if(outcomes.begin(), outcomes.end(),
                      [&](const Outcome& outcome) { return outcome.state == state; }));
}

bool Task::outOfDate() const {
    return std::any_of(outcomes.begin(), outcomes.end(),
                       [](const Outcome& outcome) { return outcome.outOfDate; });
}

std::vector<Task> results(const fs::path& records, const fs::path& program) {
    std::vector<Task> tasks = {{1, "lab1-diffuse", "Diffuse shading", {}},
                               {2, "lab2-triangle", "Ray-triangle intersection", {}},
                               {3, "lab3-shadows", "Shadows", {}},
                               {4, "lab4-reflection", "Reflection", {}},
                               {5, "lab5-refraction", "Refraction", {}},
                               {6, "lab6-supersampling", "Supersampling", {}}};
    for (Outcome& outcome : outcomes(readTests(records), readAll(records), builtAt(program)))
        if (const auto number = static_cast<std::size_t>(outcome.record.task);
            number >= 1 && number <= tasks.size())
            tasks[number - 1].outcomes.push_back(std::move(outcome));
    return tasks;
}

}  // namespace lab
