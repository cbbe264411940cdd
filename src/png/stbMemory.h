#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

namespace sw {

/// The memory that stb_image_write takes while this object lives, in its thread. Where there is no
/// more, std::bad_alloc is thrown through stb's functions: these do not expect a null pointer, and
/// would write to it. The end of the object frees what they had no time to free.
class StbMemory {
public:
    StbMemory() : outer(current) { current = this; }
    ~StbMemory() {
        while (Block* const block = all.next) remove(block);
        current = outer;
    }
    StbMemory(const StbMemory&) = delete;
    StbMemory& operator=(const StbMemory&) = delete;

    static void* allocate(std::size_t size) { return current->resize(nullptr, size); }
    static void* reallocate(void* memory, std::size_t size) {
        return current->resize(memory ? static_cast<Block*>(memory) - 1 : nullptr, size);
    }
    static void release(void* memory) {
        if (memory) current->remove(static_cast<Block*>(memory) - 1);
    }

private:
    // Stands before the memory that is handed out. All blocks are in a list.
    struct alignas(std::max_align_t) Block {
        Block *before = nullptr, *next = nullptr;
    };

    void* resize(Block* block, std::size_t size) {
        const Block links = block ? *block : Block{&all, all.next};
        void* const memory = std::realloc(block, sizeof(Block) + size);
        if (!memory) throw std::bad_alloc();
        block = ::new (memory) Block(links);
        block->before->next = block;
        if (block->next) block->next->before = block;
        return block + 1;
    }

    void remove(Block* block) {
        block->before->next = block->next;
        if (block->next) block->next->before = block->before;
        std::free(block);
    }

    Block all;  // the list's head
    StbMemory* const outer;
    static inline thread_local constinit StbMemory* current = nullptr;
};

}  // namespace sw

#define STBIW_MALLOC(size) sw::StbMemory::allocate(static_cast<std::size_t>(size))
#define STBIW_REALLOC(memory, size) \
    sw::StbMemory::reallocate(memory, static_cast<std::size_t>(size))
#define STBIW_FREE(memory) sw::StbMemory::release(memory)
