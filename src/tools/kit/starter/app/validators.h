#pragma once

#include <CLI/CLI.hpp>

/// Adds an option whose value is a number from `least` to `most`.
template <typename Value>
void addNumber(CLI::App& app, const char* name, Value& value, Value least, Value most,
               const char* text) {
    app.add_option(name, value, text)->check(CLI::Range(least, most))->capture_default_str();
}

inline std::string inPlainWords(const CLI::ParseError& error) {
    return error.what();
}
