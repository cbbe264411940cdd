#include "accel/largePages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace sw {

void useLargePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = 4096, worthwhile = 4 << 20;
    if (bytes < worthwhile) return;
    const auto start = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (start + page - 1) / page * page;
    const std::uintptr_t last = (start + bytes) / page * page;
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);  // or else: no harm
#endif
}

}  // namespace sw
