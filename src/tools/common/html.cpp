#include "tools/common/html.h"

#include <cstdint>

#include "swFile.h"

namespace html {

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
        for (int shift = 18; shift >= 0; shift -= 6) text += digits[bits >> shift & 63];
    }
    const std::size_t missing = (3 - bytes.size() % 3) % 3;
    return text.replace(text.size() - missing, missing, missing, '=');
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string figure(const std::filesystem::path& file, const std::string& caption,
                   const std::string& cssClass) {
    const std::string type = file.extension() == ".svg" ? "svg+xml" : "png";
    return "<figure class=\"" + cssClass + "\"><img alt=\"" + escaped(caption) +
           "\" src=\"data:image/" + type + ";base64," + base64(sw::readFile(file)) +
           "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

}  // namespace html
