#include "nff/nffTokens.h"

namespace sw {

// Text from the file, short and printable enough for one line of an error message.
static std::string describe(const NffToken& token) {
    if (token.text.empty()) return "the end of the file";
    std::string word;
    for (const char c : token.text.substr(0, 24)) word += c >= ' ' && c <= '~' ? c : '?';
    return word.insert(0, 1, '\'') + "'";
}

// At the next statement, the end of the file, or a word in a number's place.
void NffTokens::failAtNumber(const Group& group, int found) const {
    const std::string names = *group.hint == '\0' ? "" : std::string(": ") + group.hint;
    failAtNext("expected " + std::to_string(group.size) + " numbers after '" +
               std::string(group.keyword) + "' and there are " + std::to_string(found) + names);
}

void NffTokens::failAtExtraNumber() const {}

void NffTokens::failAtLast(const std::string& message) const {
    fail(last().begin(), message + ", found " + describe(last()));
}

void NffTokens::failAtNext(const std::string& message) const {
    fail(atEnd() ? last().end() : next.begin(), message + ", found " + describe(next));
}

}  // namespace sw
