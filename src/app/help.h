#pragma once

namespace CLI {
class App;
}

/// Sorts the options of --help into groups, and adds examples and exit codes.
/// @param app  holds all options
void arrangeHelp(CLI::App& app);

/// Refuses what is left of the command line; a mistyped option gets the nearest one.
/// @throws UsageError
void refuseUnknown(const CLI::App& app);
