#pragma once

#include <string>
#include <vector>

#include "lab/report/results.h"

namespace lab {

/// The grade as JSON: an object with the tasks, the total of their points and what it is "of". A
/// task's points are in proportion to its passed tests, rounded down: full only if all passed. A
/// test that crashed counts as failed, and so does one that has not run since the last build.
/// @param points  possible, for each of the tasks
std::string grade(const std::vector<Task>& tasks, const std::vector<int>& points);

}  // namespace lab
