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
    bool atNumber() const;

    /// Takes the numbers that follow a keyword. They must be finite.
    /// @param hint  added to the error message if there are too few: "is the radius missing?"
    void numbers(std::string_view keyword, float* values, int count, const char* hint = "") {
        numbers({keyword, count, hint}, 0, values, count);
    }

    /// Numbers that belong together but are taken in several steps.
    struct Group {
        std::string_view keyword;
        int size;
        const char* hint;
    };
    void numbers(const Group& group, int taken, float* values, int count);

    /// Throws NffError with a position in the text. `at` must point into the text or to its end.
    [[noreturn]] void fail(const char* at, const std::string& message) const;

    /// Fails at the last token taken, and adds it to the message: ", found '...'".
    [[noreturn]] void failAtLast(const std::string& message) const;

    /// "file:line:column: " for a position in the text.
    std::string place(const char* at) const;

    /// Where the text starts.
    const char* begin() const { return text.data(); }

    /// The last token taken. If something is missing, it is missing at this token's end.
    const NffToken& last() const { return previous; }

private:
    void advance();
    bool parse(float& value) const;
    [[noreturn]] void failAtNumber(const Group& group, int found) const;

    std::string_view text;
    std::string name;
    const char* position;  // behind the next token
    NffToken previous;
    NffToken next;
};

/// A token in quotes, or "the end of the file".
std::string describe(const NffToken& token);

}  // namespace sw
