// Memory taken once at load and never given back piece by piece. The host provides the block, zeroed.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

struct Arena {
    unsigned char *base;
    size_t size;
    size_t used;

    // `count` zeroed Ts on a cache line of their own; null when the arena is full.
    template <class T> T *take(size_t count) {
        size_t start = (used + 63) & ~(size_t)63;
        if (start > size || count > (size - start) / sizeof(T)) return nullptr;
        used = start + count * sizeof(T);
        return (T *)(base + start);
    }
};

} // namespace odraz
