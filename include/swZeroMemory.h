#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace sw {

/// Memory for vectors of types that are zero bytes when they are new. The system gives large pieces
/// of it as they are used, so a large picture costs no time before its pixels are set, and then
/// that of the threads that set them. Such a vector may grow, but not shrink and grow again.
template <typename T>
struct ZeroMemory {
    using value_type = T;

    ZeroMemory() = default;
    template <typename Other>
    explicit ZeroMemory(const ZeroMemory<Other>&) {}

    T* allocate(std::size_t count) {
        if (void* const memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
        throw std::bad_alloc();
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }
    /// A new element is zero already.
    void construct(T*) {}

    bool operator==(const ZeroMemory&) const = default;
};

}  // namespace sw
