#pragma once

#include <string>

namespace report {

/// Where and when times were measured, in one line: processor, compiler, date.
std::string machine();

}  // namespace report
