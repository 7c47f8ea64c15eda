// Memory for the engine's arena: zeros, which the system allocates on first use. The destructor frees it.
#pragma once

#include "base/arena.h"

#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

namespace odraz {

struct HeapArena {
    // Throws std::runtime_error if there is not enough memory.
    explicit HeapArena(size_t bytes) : memory((unsigned char *)std::calloc(1, bytes + kLine), std::free) {
        if (!memory)
            throw std::runtime_error("not enough memory: " + std::to_string(bytes >> 20) + " MB are needed");
        arena = {memory.get() + (kLine - (uintptr_t)memory.get() % kLine), bytes, 0};
    }

private:
    static constexpr size_t kLine = 64; // bytes of a cache line, the alignment of Arena::allocate()
    std::unique_ptr<unsigned char, void (*)(void *)> memory;

public:
    Arena arena;
};

} // namespace odraz
