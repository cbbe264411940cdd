#include "nff/nffTokens.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "swNffError.h"

namespace sw {
namespace {

bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool isKeyword(std::string_view word) {
    constexpr std::string_view keywords[] = {"v",  "b",     "l", "f",      "s",
                                             "p",  "pp",    "c", "from",   "at",
                                             "up", "angle", "t", "hither", "resolution"};
    return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

// Text from the file, short and printable enough for one line of an error message.
std::string printable(std::string_view text) {
    constexpr std::size_t longest = 24;
    std::string result;
    for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
    return text.size() > longest ? result + "..." : result;
}

// Some editors begin a file with an invisible byte order mark.
std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    return text.substr(0, mark.size()) == mark ? text.substr(mark.size()) : text;
}

}  // namespace

std::string describe(const NffToken& token) {
    if (token.text.empty()) return "the end of the file";
    return std::string("'").append(printable(token.text)).append("'");
}

NffTokens::NffTokens(std::string_view content, const std::string& fileName)
    : text(withoutMark(content)),
      name(fileName),
      position(text.data()),
      previous{text.substr(0, 0)} {
    advance();
}

void NffTokens::advance() {
    const char* const end = text.data() + text.size();
    while (position != end && (isSpace(*position) || *position == '#')) {
        if (*position == '#')
            position = std::find(position, end, '\n');
        else
            ++position;
    }
    const char* const start = position;
    while (position != end && !isSpace(*position) && *position != '#') ++position;
    next.text = {start, static_cast<std::size_t>(position - start)};
}

NffToken NffTokens::take() {
    previous = next;
    advance();
    return previous;
}

bool NffTokens::atNumber() const {
    if (atEnd()) return false;
    const char c = next.text[0];
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
}

bool NffTokens::parse(float& value) const {
    std::string_view digits = next.text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    const char* const end = digits.data() + digits.size();
    return fast_float::from_chars(digits.data(), end, value).ptr == end && !digits.empty();
}

void NffTokens::numbers(const Group& group, int taken, float* values, int count) {
    for (int i = 0; i < count; ++i) {
        if (!parse(values[i])) failAtNumber(group, taken + i);
        if (!std::isfinite(values[i]))
            fail(next.begin(), "expected a finite number, found " + describe(next));
        take();
    }
}

void NffTokens::failAtNumber(const Group& group, int found) const {
    if (!atEnd() && !isKeyword(next.text))
        fail(next.begin(), "expected a number, found " + describe(next));
    std::string message = "expected " + std::to_string(group.size) +
                          (group.size == 1 ? " number" : " numbers") + " after '" +
                          std::string(group.keyword) + "', found " + std::to_string(found);
    if (atEnd()) message += " and the end of the file";
    if (*group.hint != '\0') message += " (" + std::string(group.hint) + ")";
    fail(last().end(), message);
}

void NffTokens::fail(const char* at, const std::string& message) const {
    throw NffError(place(at) + message);
}

void NffTokens::failAtLast(const std::string& message) const {
    fail(last().begin(), message + ", found " + describe(last()));
}

std::string NffTokens::place(const char* at) const {
    const char* const start = text.data();
    const auto line = 1 + std::count(start, at, '\n');
    const char* lineStart = at;
    while (lineStart != start && lineStart[-1] != '\n') --lineStart;
    return name + ":" + std::to_string(line) + ":" + std::to_string(at - lineStart + 1) + ": ";
}

}  // namespace sw
