#pragma once

#include <cstddef>
#include <optional>

namespace bench {

/// Bytes that the program has allocated and not freed, overhead included; nothing where the C
/// library does not tell.
std::optional<std::size_t> allocatedBytes();

/// While it lives, the program runs on one processor, so that a tree is built by one thread: the
/// Scene takes as many threads as there are processors. Does nothing where it cannot.
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
