#pragma once

#include <string>

namespace report {

/// One line that says where and when times were measured: processor, compiler, date.
std::string machine();

}  // namespace report
