#include "nff/nffText.h"

namespace sw {
namespace {

// How a file stores its characters: each in one or two units of a fixed size.
struct Encoding {
    std::size_t unit = 1;  // bytes; 1: UTF-8, ASCII or one of its other relatives
    bool bigEndian = false;
};

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

// By the byte order mark, or by the zeros beside the first character: every file begins with a
// character of ASCII.
Encoding encodingOf(std::string_view bytes) {
    using namespace std::string_view_literals;
    const auto isZero = [bytes](std::size_t i) { return i < bytes.size() && bytes[i] == '\0'; };
    if (startsWith(bytes, "\xff\xfe\0\0"sv)) return {4, false};
    if (startsWith(bytes, "\0\0\xfe\xff"sv)) return {4, true};
    if (startsWith(bytes, "\xff\xfe"sv)) return {2, false};
    if (startsWith(bytes, "\xfe\xff"sv)) return {2, true};
    if (isZero(0) && isZero(1) && isZero(2) && !isZero(3)) return {4, true};
    if (isZero(1) && isZero(2) && isZero(3) && !isZero(0)) return {4, false};
    if (isZero(0) && !isZero(1)) return {2, true};
    if (isZero(1) && !isZero(0)) return {2, false};
    return {};
}

constexpr char32_t unreadable = 0xFFFD;  // Unicode's replacement character
constexpr char32_t byteOrderMark = 0xFEFF;

void appendUtf8(std::string& text, char32_t c) {
    const auto byte = [&text](char32_t value) {
        text += static_cast<char>(static_cast<unsigned char>(value));
    };
    if (c < 0x80) return byte(c);
    if (c < 0x800) {
        byte(0xC0 | c >> 6);
    } else if (c < 0x10000) {
        byte(0xE0 | c >> 12);
        byte(0x80 | (c >> 6 & 0x3F));
    } else {
        byte(0xF0 | c >> 18);
        byte(0x80 | (c >> 12 & 0x3F));
        byte(0x80 | (c >> 6 & 0x3F));
    }
    byte(0x80 | (c & 0x3F));
}

// Takes one character after the other from UTF-16 or UTF-32.
class Characters {
public:
    Characters(std::string_view bytes, Encoding encoding) : rest(bytes), encoding(encoding) {}

    bool atEnd() const { return rest.empty(); }

    char32_t take() {
        const char32_t first = unit();
        if (first < 0xD800 || first > 0xDFFF) return first > 0x10FFFF ? unreadable : first;
        // A character beyond the first 65536 is a high and a low surrogate.
        const Characters before = *this;
        const char32_t second = atEnd() ? unreadable : unit();
        if (first < 0xDC00 && second >= 0xDC00 && second <= 0xDFFF)
            return 0x10000 + ((first - 0xD800) << 10) + (second - 0xDC00);
        *this = before;
        return unreadable;
    }

private:
    char32_t unit() {
        const std::string_view bytes = rest.substr(0, encoding.unit);
        rest.remove_prefix(bytes.size());
        if (bytes.size() < encoding.unit) return unreadable;
        char32_t value = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const char byte = bytes[encoding.bigEndian ? i : bytes.size() - 1 - i];
            value = value << 8 | static_cast<unsigned char>(byte);
        }
        return value;
    }

    std::string_view rest;
    Encoding encoding;
};

std::string toUtf8(std::string_view bytes, Encoding encoding) {
    std::string text;
    text.reserve(bytes.size() / encoding.unit + 16);
    for (Characters all(bytes, encoding); !all.atEnd();) appendUtf8(text, all.take());
    return text;
}

}  // namespace

std::string_view decodeText(std::string_view bytes, std::string& storage) {
    const Encoding encoding = encodingOf(bytes);
    std::string_view text = bytes;
    if (encoding.unit > 1) text = storage = toUtf8(bytes, encoding);
    std::string mark;
    appendUtf8(mark, byteOrderMark);
    if (startsWith(text, mark)) text.remove_prefix(mark.size());
    while (!text.empty() && text.back() == '\x1a') text.remove_suffix(1);
    return text;
}

}  // namespace sw
