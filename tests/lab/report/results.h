#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/record.h"

/// How far a student is: what the records say of each of the six tasks.
namespace lab {

/// A test case and what is known about it.
struct Outcome {
    enum class State { passed, failed, crashed, notRun };

    Record record;  ///< only the task and the test's name are set where it was not run
    State state = State::notRun;
    bool outOfDate = false;  ///< has run, but the tests were built again since
};

struct Task {
    int number;         ///< 1..6
    std::string label;  ///< of its tests: "lab3-shadows"
    std::string title;
    std::vector<Outcome> outcomes;  ///< in the order of the test file

    /// How many tests have come out so, out of date or not.
    int count(Outcome::State state) const;
    bool outOfDate() const;  ///< any of its tests
    int size() const { return static_cast<int>(outcomes.size()); }
};

/// All six tasks. Records of tests that are no more are passed over.
/// @param records  the folder
/// @param program  that runs the tests; where there is none, all records are out of date
std::vector<Task> results(const std::filesystem::path& records,
                          const std::filesystem::path& program);

}  // namespace lab
