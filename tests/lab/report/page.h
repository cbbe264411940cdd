#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lab/report/results.h"

namespace lab {

/// The report as one web page that needs nothing but itself: no script, no network.
/// @param records  the folder that holds the pictures; one that is missing is left out
/// @param when     the time of the run, as shown; empty if there was none
std::string page(const std::vector<Task>& tasks, const std::filesystem::path& records,
                 const std::string& when);

}  // namespace lab
