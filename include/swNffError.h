#pragma once

#include <stdexcept>

namespace sw {

/// A scene file that cannot be read. The message is `file:line:column: expected ..., found ...`,
/// or `file: reason` if the error has no position.
class NffError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace sw
