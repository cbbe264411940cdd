#include "png/stbMemory.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "support.h"

using sw::StbMemory;
using namespace test;

namespace {

struct Piece {
    unsigned char* memory;
    std::size_t size;
    unsigned char fill;

    bool isIntact() const {
        for (std::size_t i = 0; i < size; ++i)
            if (memory[i] != fill) return false;
        return reinterpret_cast<std::uintptr_t>(memory) % alignof(std::max_align_t) == 0;
    }
};

Piece piece(void* memory, std::size_t size, unsigned char fill) {
    std::memset(memory, fill, size);
    return {static_cast<unsigned char*>(memory), size, fill};
}

}  // namespace

// A sanitizer tells of leaks and of bytes beyond the end.
TEST_CASE("memory keeps its content through any allocations, and is freed in the end") {
    Random random(GENERATE(range(0u, 20u)));
    const StbMemory memory;
    std::vector<Piece> pieces;
    for (int i = 0; i < 500; ++i) {
        const auto size = static_cast<std::size_t>(random.whole(1, 300));
        const auto fill = static_cast<unsigned char>(random.whole(0, 255));
        const int kind = random.whole(0, 3);
        if (kind < 2 || pieces.empty()) {
            void* const fresh =
                kind == 0 ? StbMemory::allocate(size) : StbMemory::reallocate(nullptr, size);
            pieces.push_back(piece(fresh, size, fill));
            continue;
        }
        std::swap(
            pieces[static_cast<std::size_t>(random.whole(0, static_cast<int>(pieces.size()) - 1))],
            pieces.back());
        const Piece old = pieces.back();
        REQUIRE(old.isIntact());
        pieces.pop_back();
        if (kind == 2) {
            StbMemory::release(old.memory);
        } else {
            auto* const moved =
                static_cast<unsigned char*>(StbMemory::reallocate(old.memory, size));
            CHECK(Piece{moved, std::min(size, old.size), old.fill}.isIntact());
            pieces.push_back(piece(moved, size, fill));
        }
    }
    for (const Piece& p : pieces) CHECK(p.isIntact());
    StbMemory::release(nullptr);
}

TEST_CASE("memory that ends throws, and what was there stays") {
    const StbMemory outer;
    const Piece kept = piece(StbMemory::allocate(10), 10, 7);
    {
        const StbMemory inner;
        CHECK_THROWS_AS(StbMemory::allocate(SIZE_MAX / 4), std::bad_alloc);
    }
    CHECK_THROWS_AS(StbMemory::reallocate(kept.memory, SIZE_MAX / 4), std::bad_alloc);
    CHECK(kept.isIntact());
}
