#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

/// A command line that makes no sense. The message says what to do instead.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// For ways to use the program that exclude each other.
/// @throws UsageError if the command line holds one of the others beside `way`
void refuseBeside(const CLI::App& app, const std::string& way,
                  std::initializer_list<const char*> others);
