// Memory taken once at load and never given back piece by piece. The host provides the block, zeroed.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

struct Arena {
    unsigned char *base;
    size_t size;
    size_t used;
    bool full = false; // something did not fit. A caller that takes many things may check this once

    // `count` zeroed Ts that start on a cache line of their own; null when they do not fit.
    template <class T> T *take(size_t count) { return (T *)take(count, sizeof(T)); }

private:
    void *take(size_t count, size_t each);
};

} // namespace odraz
