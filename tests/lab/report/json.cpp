#include "json.h"

#include <string_view>

namespace lab {
namespace {

// How many bytes the character in front takes; 0 if it is no well-formed UTF-8 (The Unicode
// Standard, table 3-7).
std::size_t characterSize(std::string_view text) {
    const auto within = [&](std::size_t i, int least, int most) {
        const int byte = i < text.size() ? static_cast<unsigned char>(text[i]) : -1;
        return least <= byte && byte <= most;
    };
    const auto following = [&](std::size_t i) { return within(i, 0x80, 0xbf); };
    if (within(0, 0, 0x7f)) return 1;
    if (within(0, 0xc2, 0xdf)) return following(1) ? 2 : 0;
    if (within(0, 0xe0, 0xef)) {
        const int least = within(0, 0xe0, 0xe0) ? 0xa0 : 0x80;  // not longer than need be
        const int most = within(0, 0xed, 0xed) ? 0x9f : 0xbf;   // no surrogates
        return within(1, least, most) && following(2) ? 3 : 0;
    }
    if (within(0, 0xf0, 0xf4)) {
        const int least = within(0, 0xf0, 0xf0) ? 0x90 : 0x80;
        const int most = within(0, 0xf4, 0xf4) ? 0x8f : 0xbf;  // up to U+10FFFF
        return within(1, least, most) && following(2) && following(3) ? 4 : 0;
    }
    return 0;
}

std::string escapedCharacter(char c) {
    constexpr char digits[] = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') return std::string("\\") + c;
    if (c == '\n') return "\\n";
    if (byte < 0x20) return std::string("\\u00") + digits[byte >> 4] + digits[byte & 15];
    return std::string(1, c);
}

}  // namespace

std::string jsonString(const std::string& text) {
    std::string json = "\"";
    for (std::size_t i = 0, size; i < text.size(); i += size) {
        size = characterSize(std::string_view(text).substr(i));
        if (size == 0) {
            json += "\\ufffd";
            size = 1;
        } else {
            json += size == 1 ? escapedCharacter(text[i]) : text.substr(i, size);
        }
    }
    return json + "\"";
}

}  // namespace lab
