#include "nff/nffHints.h"

#include <fast_float/fast_float.h>

#include <cstdio>

namespace sw {
namespace {

using namespace std::string_view_literals;

struct Known {
    std::string_view text;
    const char* what;
};

// The first word of a file, or a word that another format has and this one has not.
constexpr Known words[] = {{"pl", "an infinite plane of another dialect: use a large polygon"},
                           {"tess", "a word of assimp's dialect"},
                           {"tpp", "a textured patch of another dialect: use 'pp'"},
                           {"fm", "a material of BART's dialect: use 'f'"},
                           {"tt", "a word of BART's dialect"},
                           {"ttpp", "a word of BART's dialect"},
                           {"xs", "a word of BART's dialect"},
                           {"nff", "Sense8's format, which only shares the name NFF"},
                           {"camera", "a POV-Ray file?"},
                           {"light_source", "a POV-Ray file?"},
                           {"global_settings", "a POV-Ray file?"},
                           {"mtllib", "a Wavefront OBJ file?"},
                           {"usemtl", "a Wavefront OBJ file?"},
                           {"vn", "a Wavefront OBJ file?"},
                           {"vt", "a Wavefront OBJ file?"},
                           {"o", "a Wavefront OBJ file?"},
                           {"ply", "a PLY file?"},
                           {"solid", "an STL file?"},
                           {"OFF", "an OFF file?"}};

constexpr Known beginnings[] = {{"\x89PNG", "this is a PNG picture"},
                                {"\xff\xd8\xff", "this is a JPEG picture"},
                                {"GIF8", "this is a GIF picture"},
                                {"%PDF", "this is a PDF file"},
                                {"PK\x03\x04", "this is a ZIP archive"},
                                {"\x1f\x8b", "this is a gzip archive"},
                                {"\x7f"
                                 "ELF",
                                 "this is a program"},
                                {"{\\rtf", "this is an RTF document: save it as plain text"},
                                {"<?xml", "this is XML"},
                                {"<!DOCTYPE", "this is a web page"},
                                {"<html", "this is a web page"}};

std::string formatOf(std::string_view token) {
    for (const Known& word : words)
        if (token == word.text) return word.what;
    for (const Known& start : beginnings)
        if (token.substr(0, start.text.size()) == start.text) return start.what;
    return "";
}

struct LookAlike {
    unsigned first, last;  // code points
    const char* name;
    const char* wayOut;
};

constexpr const char *space = ": type a plain space", *minus = ": type a plain -",
                     *nothing = ": delete it", *plain = ": type it plain";
constexpr LookAlike lookAlikes[] = {{0x00, 0x00, "a NUL byte", ": is this a text file?"},
                                    {0x1A, 0x1A, "a Ctrl-Z", nothing},
                                    {0xA0, 0xA0, "a no-break space", space},
                                    {0xAD, 0xAD, "a soft hyphen", nothing},
                                    {0x2000, 0x200A, "a wide or narrow space", space},
                                    {0x200B, 0x200B, "a zero width space", nothing},
                                    {0x200C, 0x200D, "a zero width joiner", nothing},
                                    {0x200E, 0x200F, "a direction mark", nothing},
                                    {0x2010, 0x2011, "a hyphen", minus},
                                    {0x2012, 0x2012, "a figure dash", minus},
                                    {0x2013, 0x2013, "an en dash", minus},
                                    {0x2014, 0x2014, "an em dash", minus},
                                    {0x2018, 0x201F, "a quotation mark", nothing},
                                    {0x2028, 0x2029, "a line separator", ": end the line plainly"},
                                    {0x202F, 0x202F, "a narrow no-break space", space},
                                    {0x205F, 0x205F, "a wide or narrow space", space},
                                    {0x2060, 0x2060, "a word joiner", nothing},
                                    {0x2212, 0x2212, "a minus sign", minus},
                                    {0x3000, 0x3000, "an ideographic space", space},
                                    {0xFE63, 0xFE63, "a small hyphen", minus},
                                    {0xFEFF, 0xFEFF, "a byte order mark", nothing},
                                    {0xFF0D, 0xFF0D, "a full-width minus", minus},
                                    {0xFF01, 0xFF5E, "a full-width character", plain},
                                    {0xFFFD, 0xFFFD, "an unreadable character", ""}};

unsigned byteAt(std::string_view text, std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// The character of UTF-8 that the text begins with, or -1 if it is none.
int codePointOf(std::string_view text) {
    const unsigned first = byteAt(text, 0);
    const int more = first < 0x80 ? 0 : first >> 5 == 6 ? 1 : first >> 4 == 14 ? 2 : -1;
    if (more < 0) return -1;
    unsigned code = more == 0 ? first : first & (0x3Fu >> more);
    for (int i = 1; i <= more; ++i) {
        const unsigned next = byteAt(text, static_cast<std::size_t>(i));
        if (next >> 6 != 2) return -1;
        code = code << 6 | (next & 0x3F);
    }
    return static_cast<int>(code);
}

// Names the first character that the format does not have, but may look as if it had.
std::string oddCharacter(std::string_view token) {
    std::size_t at = 0;
    while (at < token.size() && token[at] > ' ' && token[at] <= '~') ++at;
    if (at == token.size()) return "";
    const int code = codePointOf(token.substr(at));
    char number[16];
    std::snprintf(number, sizeof number, code < 0 ? "0x%02X" : "U+%04X",
                  code < 0 ? byteAt(token, at) : static_cast<unsigned>(code));
    for (const LookAlike& known : lookAlikes)
        if (code >= static_cast<int>(known.first) && code <= static_cast<int>(known.last))
            return std::string(known.name) + ", " + number + known.wayOut;
    return (code < 0 ? "the byte " : "the character ") + std::string(number) + " is not plain text";
}

// Old Windows programs print 1.#INF, -1.#IND and 1.#QNAN.
std::string numberSign(std::string_view token) {
    const std::size_t at = token.find('#');
    if (at == std::string_view::npos) return "";
    const std::string_view rest = token.substr(at + 1);
    if (rest.substr(0, 3) == "INF") return "infinity, as old Windows programs print it";
    for (const auto nan : {"IND"sv, "QNAN"sv, "SNAN"sv})
        if (rest.substr(0, nan.size()) == nan)
            return "not a number, as old Windows programs print it";
    return "a comment needs a space before its #";
}

// The text behind the number that it begins with; the whole text if it begins with none.
std::string_view behindNumber(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    const std::string_view digits = text.substr(plus);
    double value;
    const auto end = fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
    const auto used = static_cast<std::size_t>(end.ptr - digits.data());
    return used == 0 ? text : digits.substr(used);
}

// 0.25-1 or 0.5.5.5.
std::string gluedNumbers(std::string_view token) {
    std::string_view rest = token;
    int count = 0;
    for (; !rest.empty(); ++count) {
        const std::string_view next = behindNumber(rest);
        if (next.size() == rest.size()) return "";
        rest = next;
    }
    return count < 2 ? "" : "numbers glued together: separate them by spaces";
}

}  // namespace

std::string hintAbout(std::string_view token) {
    for (const auto find : {formatOf, oddCharacter, numberSign, gluedNumbers})
        if (const std::string hint = find(token); !hint.empty()) return " (" + hint + ")";
    return "";
}

}  // namespace sw
