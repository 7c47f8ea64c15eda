// A block of memory that is allocated once, at load, and handed out piece by piece. No piece is ever freed.
// The host provides the block, zeroed.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

struct Arena {
    unsigned char *base;
    size_t size;
    size_t used;
    bool full = false; // some take() failed. A caller of many may check this once, at the end

    // Returns `count` zeroed Ts that start on a new cache line; null if they do not fit.
    template <class T> T *take(size_t count) { return (T *)take(count, sizeof(T)); }

private:
    void *take(size_t count, size_t bytesEach);
};

} // namespace odraz
