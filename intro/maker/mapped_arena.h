// An arena that owns its memory: zeroed at first, unmapped by the destructor.
#pragma once

#include "base/arena.h"

#include <sys/mman.h>
#include <utility>

namespace odraz::maker {

class MappedArena {
public:
    MappedArena() = default;
    explicit MappedArena(size_t bytes) {
        void *memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory != MAP_FAILED) arena = {(unsigned char *)memory, bytes, 0};
    }
    ~MappedArena() {
        if (arena.base) munmap(arena.base, arena.size);
    }
    MappedArena(MappedArena &&other) : arena(std::exchange(other.arena, {})) {}
    MappedArena &operator=(MappedArena &&other) { return std::swap(arena, other.arena), *this; }

    Arena arena = {}; // its base is null if there was not enough memory
};

} // namespace odraz::maker
