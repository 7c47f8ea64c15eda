#include "base/arena.h"

namespace odraz {

void *Arena::allocate(size_t count, size_t bytesEach) {
    size_t start = (used + 63) & ~(size_t)63;
    if (start > size || count > (size - start) / bytesEach) {
        full = true;
        return nullptr;
    }
    used = start + count * bytesEach;
    return base + start;
}

} // namespace odraz
