#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace lab {

/// What lab_report does:
///   page RECORDS PROGRAM PAGE          writes the report
///   grade RECORDS PROGRAM JSON POINTS  writes the grade, and shows it; POINTS: six numbers,
///   "10,..."
/// where RECORDS is the folder of the records and PROGRAM the one that runs the lab's tests.
/// @return exit code: 0; 1 with one line on err if a file cannot be written; 2 if it is used
/// wrongly
int reportProgram(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace lab
