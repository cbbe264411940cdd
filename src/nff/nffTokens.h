#pragma once

#include <string>
#include <string_view>

namespace sw {

/// A piece of text between white space. Empty at the end of the text.
struct NffToken {
    std::string_view text;
    const char* begin() const { return text.data(); }
    const char* end() const { return text.data() + text.size(); }
};

/// LF, CR, or both in this order end a line.
inline bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

/// How many lines end in a piece of text.
int countLineEnds(const char* begin, const char* end);

/// Splits the text of a scene file into words and numbers, and reports errors with positions.
/// The text must outlive the tokens.
class NffTokens {
public:
    NffTokens(std::string_view content, const std::string& fileName);

    /// The next token, without taking it.
    const NffToken& peek() const { return next; }
    /// Takes the next token.
    NffToken take();

    bool atEnd() const { return next.text.empty(); }
    /// Whether the next token looks like a number. No keyword does.
    bool atNumber() const { return isNumeric(next.text); }

    /// Numbers that belong together.
    struct Group {
        std::string_view keyword;
        int size = 0;
        const char* hint = "";  ///< what they are, for error messages: "x y z radius"
    };
    /// Takes the next `count` numbers of a group of which `taken` are taken already. They must be
    /// finite.
    void numbers(const Group& group, float* values, int count, int taken = 0);

    /// Fails if more numbers follow than belong to the last complete group.
    void expectNoNumber() const {
        if (atNumber()) failAtExtraNumber();
    }

    /// Throws NffError with a position in the text. `at` must point into the text or to its end.
    [[noreturn]] void fail(const char* at, const std::string& message) const;

    /// Fails at the last token taken, and adds it to the message: ", found '...'".
    [[noreturn]] void failAtLast(const std::string& message) const;
    /// The same with the next token.
    [[noreturn]] void failAtNext(const std::string& message) const;

    /// "file:line:column: " for a position in the text.
    std::string place(const char* at) const;

    /// Where the text starts.
    const char* begin() const { return text.data(); }

    /// The last token taken. If something is missing, it is missing at this token's end.
    const NffToken& last() const { return previous; }

private:
    static bool isNumeric(std::string_view word) {
        const char c = word.empty() ? ' ' : word[0];
        return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
    }
    void advance();
    bool parse(float& value) const;
    [[noreturn]] void failAtNumber(const Group& group, int found) const;
    void failAtExtraNumber() const;

    std::string_view text;
    std::string name;
    const char* position;  // behind the next token
    NffToken previous;
    NffToken next;
    Group lastGroup;  // that was taken whole
};

}  // namespace sw
