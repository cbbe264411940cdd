#pragma once

#include <sstream>
#include <string>

#include "swVec3.h"

namespace sw {

/// A stream that formats numbers the same way in every locale.
std::ostringstream plainStream();

/// A number with six digits, the same in every locale; -0 becomes 0, and any NaN "nan".
std::string plainText(float number);
/// "(1, 2, 3)".
std::string plainText(const Vec3& v);

}  // namespace sw
