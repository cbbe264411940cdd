#pragma once

#include <cstddef>
#include <optional>

namespace bench {

/// Bytes that the program has allocated and not freed, including overhead; nothing if the C library
/// does not tell.
std::optional<std::size_t> allocatedBytes();

/// During its lifetime the program runs on one processor. A Scene builds its tree with one thread
/// per processor, so it then uses one thread. Does nothing on systems without support.
class OneProcessor {
public:
    OneProcessor();
    ~OneProcessor();
    OneProcessor(const OneProcessor&) = delete;
    OneProcessor& operator=(const OneProcessor&) = delete;

private:
    struct Before;
    [[maybe_unused]] Before* before = nullptr;
};

}  // namespace bench
