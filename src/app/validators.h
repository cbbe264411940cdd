#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <type_traits>

// What an option takes, for CLI::Option::transform(). Anything else is refused with what was
// expected and found.

/// Whole numbers from `least` to `most`, in decimal digits.
CLI::Validator wholeNumber(std::uint64_t least, std::uint64_t most);

/// Numbers from `least` to `most`.
CLI::Validator number(double least, double most);

/// Any text but an empty one.
CLI::Validator fileName();

/// Adds an option whose value is a number from `least` to `most`; whole if its type is.
template <typename Value>
void addNumber(CLI::App& app, const char* name, Value& value, Value least, Value most,
               const char* text) {
    CLI::Option* const option = app.add_option(name, value, text)->capture_default_str();
    if constexpr (std::is_integral_v<Value>)
        option->transform(
            wholeNumber(static_cast<std::uint64_t>(least), static_cast<std::uint64_t>(most)));
    else
        option->transform(number(least, most));
}

/// CLI11's message, or ours where it speaks of types and counts.
std::string inPlainWords(const CLI::ParseError& error);
