// Memory that the host allocates once, zeroed, and that is handed out in pieces. No piece is ever freed.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

struct Arena {
    unsigned char *base;
    size_t size;
    size_t used;
    bool full = false; // some allocate() failed. After many calls it is enough to check this once
    // Null, or gives memory back to the system, in whole pages. That memory must not be used again
    void (*giveBack)(void *memory, size_t bytes) = nullptr;

    // Returns `count` zeroed Ts that start on a new cache line; null if they do not fit.
    template <class T> T *allocate(size_t count) { return (T *)allocate(count, sizeof(T)); }

private:
    void *allocate(size_t count, size_t bytesEach);
};

} // namespace odraz
