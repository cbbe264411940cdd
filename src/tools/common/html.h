#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// Parts of a self-contained web page.
namespace html {

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// Escapes text for elements and quoted attributes.
std::string escaped(std::string_view text);

/// A picture embedded in the page, with a caption.
/// @param file  .png or .svg
/// @throws sw::FileError
std::string figure(const std::filesystem::path& file, const std::string& caption,
                   const std::string& cssClass);

}  // namespace html
