#include "app/usage.h"

#include <CLI/CLI.hpp>

void refuseBeside(const CLI::App& app, const std::string& way,
                  std::initializer_list<const char*> others) {
    for (const std::string other : others)
        if (const auto* option = app.get_option_no_throw(other); option && option->count() > 0)
            throw UsageError(way + ": expected no " + other +
                             " beside it, found both (leave one out)");
}
