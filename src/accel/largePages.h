#pragma once

#include <cstddef>
#include <vector>

namespace sw {

/// Asks the system for large pages behind memory that is not used yet. Rays jump about in a large
/// scene, and of the usual pages of 4 KiB a processor remembers only some thousands.
/// Does nothing where the system knows no such request, or the memory is small.
void useLargePages(void* memory, std::size_t bytes);

/// Reserves room for `size` elements in an empty vector, in large pages.
template <typename T>
void reserveInLargePages(std::vector<T>& vector, std::size_t size) {
    vector.reserve(size);
    useLargePages(vector.data(), size * sizeof(T));
}

}  // namespace sw
