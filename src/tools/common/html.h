#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Pieces of a web page that needs nothing but itself.
namespace html {

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// Text as it is, whatever it holds: for elements and for quoted attributes.
std::string escaped(std::string_view text);

/// A picture inside the page, with a line below.
/// @param file  .png or .svg
/// @throws sw::FileError
std::string figure(const std::filesystem::path& file, const std::string& caption,
                   const std::string& cssClass);

}  // namespace html
