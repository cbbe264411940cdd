#pragma once

#include <string>
#include <string_view>

namespace sw {

/// The characters of a scene file in UTF-8. Files in UTF-16 and UTF-32, as some Windows programs
/// write them, are converted, whether or not they begin with a byte order mark. The mark is left
/// out, and so is the Ctrl-Z that ends files of DOS days.
/// @param bytes    must outlive the result
/// @param storage  holds the result if it had to be converted, and must outlive it
std::string_view decodeText(std::string_view bytes, std::string& storage);

}  // namespace sw
