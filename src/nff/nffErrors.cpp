// What NffTokens says about tokens that it did not expect.

#include <algorithm>
#include <iterator>

#include "nff/nffHints.h"
#include "nff/nffTokens.h"

namespace sw {
namespace {

bool isKeyword(std::string_view word) {
    constexpr std::string_view keywords[] = {"v",      "b",          "l",      "f",  "s",  "p",
                                             "pp",     "c",          "from",   "at", "up", "angle",
                                             "hither", "resolution", "number", "g"};
    return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Text from the file, short and printable enough for one line of an error message.
std::string printable(std::string_view text) {
    constexpr std::size_t longest = 24;
    std::string result;
    for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
    return text.size() > longest ? result + "..." : result;
}

std::string describe(const NffToken& token) {
    if (token.text.empty()) return "the end of the file";
    return "'" + printable(token.text) + "'" + hintAbout(token.text);
}

// "expected 8 numbers after 'f', found 7".
std::string counts(const NffTokens::Group& group, int found) {
    return "expected " + std::to_string(group.size) + (group.size == 1 ? " number" : " numbers") +
           " after '" + std::string(group.keyword) + "', found " + std::to_string(found);
}

// ": 2 are missing".
std::string missing(int count) {
    return count == 1 ? ": 1 is missing" : ": " + std::to_string(count) + " are missing";
}

// Whether the next token is a word behind which no number follows: a name, which takes no number's
// place.
bool isLastWord(NffTokens tokens) {
    return isLetter(tokens.take().text[0]) && !tokens.atNumber();
}

}  // namespace

void NffTokens::failAtNumber(const Group& group, int found) const {
    const int left = group.size - found;
    if (!atEnd() && !isKeyword(next.text)) {
        if (isLastWord(*this))
            fail(next.begin(), counts(group, found) + " before " + describe(next) + missing(left));
        failAtNext("expected a number");
    }
    std::string message = counts(group, found);
    if (atEnd()) message += " and the end of the file";
    if (found > 0) message += missing(left);
    if (*group.hint != '\0') message += " (" + std::string(group.hint) + ")";
    fail(last().end(), message);
}

void NffTokens::failAtExtraNumber() const {
    NffTokens tokens = *this;
    float ignored;
    int found = lastGroup.size;
    for (; tokens.parse(ignored); tokens.take()) ++found;
    if (lastGroup.size > 0 && found > lastGroup.size) fail(next.begin(), counts(lastGroup, found));
}

void NffTokens::failAtLast(const std::string& message) const {
    fail(last().begin(), message + ", found " + describe(last()));
}

void NffTokens::failAtNext(const std::string& message) const {
    // As Wavefront OBJ files begin, whose v is a vertex.
    const bool isObj = last().text == "v" && atNumber();
    fail(atEnd() ? last().end() : next.begin(),
         message + ", found " + describe(next) + (isObj ? " (a Wavefront OBJ file?)" : ""));
}

}  // namespace sw
