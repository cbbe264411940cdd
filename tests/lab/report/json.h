#pragma once

#include <string>

namespace lab {

/// A text as a JSON string, with its quotes. Bytes that are no UTF-8 become U+FFFD.
std::string jsonString(const std::string& text);

}  // namespace lab
