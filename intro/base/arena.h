// Memory taken once at load and never given back piece by piece. The host provides the block, zeroed.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

struct Arena {
    unsigned char *base;
    size_t size;
    size_t used;
    bool full = false; // it could not give all that was asked for: who takes many things may ask once

    // `count` zeroed Ts on a cache line of their own; null when there is not so much left.
    template <class T> T *take(size_t count) { return (T *)take(count, sizeof(T)); }

private:
    void *take(size_t count, size_t each);
};

} // namespace odraz
