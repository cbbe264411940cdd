#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sw {

/// Asks for large pages where memory will soon be filled: a ray that jumps about in a large scene
/// spends much of its time looking up the addresses of small ones. A hint; elsewhere than on Linux
/// it does nothing.
inline void preferLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
    constexpr std::uintptr_t page = 4096;
    const std::uintptr_t start = reinterpret_cast<std::uintptr_t>(memory) + page - 1;
    if (bytes > 2 * page)
        madvise(reinterpret_cast<void*>(start / page * page), bytes - page, MADV_HUGEPAGE);
#endif
}

}  // namespace sw
