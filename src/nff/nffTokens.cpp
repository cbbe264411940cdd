#include "nff/nffTokens.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>

#include "swNffError.h"

namespace sw {
namespace {

bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

bool endsToken(char c) {
    return c <= '#' && (c == '#' || isSpace(c));  // what numbers are made of comes after '#'
}

}  // namespace

int countLineEnds(const char* begin, const char* end) {
    int count = 0;
    for (const char* at = begin; at != end; ++at)
        count += *at == '\r' || (*at == '\n' && (at == begin || at[-1] != '\r'));
    return count;
}

NffTokens::NffTokens(std::string_view content, const std::string& fileName)
    : text(content), name(fileName), position(text.data()), previous{text.substr(0, 0)} {
    advance();
}

void NffTokens::advance() {
    const char* const end = text.data() + text.size();
    while (position != end && endsToken(*position)) {
        if (*position == '#')
            position = std::find_if(position, end, isLineEnd);
        else
            ++position;
    }
    const char* const start = position;
    const auto token = [&] {
        return std::string_view(start, static_cast<std::size_t>(position - start));
    };
    // Behind a number, # begins no comment: -1.#IND is not -1.
    while (position != end && (!endsToken(*position) || (*position == '#' && isNumeric(token()))))
        ++position;
    next.text = token();
}

NffToken NffTokens::take() {
    previous = next;
    advance();
    return previous;
}

bool NffTokens::parse(float& value) const {
    std::string_view digits = next.text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    const char* const end = digits.data() + digits.size();
    return fast_float::from_chars(digits.data(), end, value).ptr == end && !digits.empty();
}

void NffTokens::numbers(const Group& group, float* values, int count, int taken) {
    for (int i = 0; i < count; ++i) {
        if (!parse(values[i])) failAtNumber(group, taken + i);
        if (!std::isfinite(values[i])) failAtNext("expected a finite number");
        take();
    }
    if (taken + count == group.size) lastGroup = group;
}

void NffTokens::fail(const char* at, const std::string& message) const {
    throw NffError(place(at) + message);
}

std::string NffTokens::place(const char* at) const {
    const char* const start = text.data();
    const int line = 1 + countLineEnds(start, at);
    const char* lineStart = at;
    while (lineStart != start && !isLineEnd(lineStart[-1])) --lineStart;
    return name + ":" + std::to_string(line) + ":" + std::to_string(at - lineStart + 1) + ": ";
}

}  // namespace sw
