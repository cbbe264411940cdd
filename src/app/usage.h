#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

/// An invalid command line. The message says what to do instead.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Refuses options that exclude each other.
/// @throws UsageError if the command line has one of `others` beside `way`
void refuseBeside(const CLI::App& app, const std::string& way,
                  std::initializer_list<const char*> others);
